// The body of accumulateSh, compiled once for each instruction set by the files that include it.

#include "shprt/sh/accumulate.h"
#include "shprt/sh/evaluation_kernel.h"

namespace shprt {
namespace {

// Adds to one vector for each coefficient.
template <int kVectors>
struct SumSink {
  Lanes* sums;

  SHPRT_INLINE void tell(int i, const Lanes (&a)[kVectors], const Lanes (&b)[kVectors]) {
    Lanes sum = sums[i];
    SHPRT_UNROLL for (int v = 0; v < kVectors; ++v) sum += a[v] * b[v];
    sums[i] = sum;
  }
};

// Lane sums of one coefficient into a double, in a fixed order.
SHPRT_INLINE double foldLanes(const Lanes& lanes) {
  double sum = 0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) sum += static_cast<double>(lanes[lane]);
  return sum;
}

template <int kDegree, int kVectors>
SHPRT_INLINE void accumulateVectors(const EvaluationTables& tables, int degree, const float* x,
                                    const float* y, const float* z, const float* weight, Lanes* sums) {
  Directions<kVectors> u;
  prepare(x, y, z, u);
  SHPRT_UNROLL for (int v = 0; v < kVectors; ++v) {
    loadLanes(weight + v * kLanes, u.weight[v]);
    u.floor[v] = u.weight[v] * kFloor;
  }
  SumSink<kVectors> sink{sums};
  evaluateVectors<kDegree>(tables, degree, u, sink);
}

// kVectors is a power of two, at most 16.
template <int kVectors>
SHPRT_INLINE void accumulateKernel(int degree, const float* x, const float* y, const float* z,
                                   const float* weight, std::size_t count, double* sums) {
  const EvaluationTables& tables = evaluationTables();
  withDegree(degree, [&]<int kDegree>() {
    constexpr std::size_t kFold = 16 * kLanes, kStep = kVectors * kLanes;
    const int coefficients = (degree + 1) * (degree + 1);
    Lanes lanes[kDegree == kAnyDegree ? kMaximumFloatCoefficients : (kDegree + 1) * (kDegree + 1)];
    for (int i = 0; i < coefficients; ++i) sums[i] = 0;
    for (std::size_t first = 0; first < count; first += kFold) {
      for (int i = 0; i < coefficients; ++i) lanes[i] = Lanes{};
      const std::size_t end = first + kFold < count ? first + kFold : count;
      std::size_t k = first;
      for (; k + kStep <= end; k += kStep)
        accumulateVectors<kDegree, kVectors>(tables, degree, x + k, y + k, z + k, weight + k, lanes);
      for (; k < end; k += kLanes)
        accumulateVectors<kDegree, 1>(tables, degree, x + k, y + k, z + k, weight + k, lanes);
      for (int i = 0; i < coefficients; ++i) sums[i] += foldLanes(lanes[i]);
    }
  });
}

}  // namespace
}  // namespace shprt
