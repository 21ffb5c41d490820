// The body of evaluateShBatch, compiled once for each instruction set by the files that include it.

#include "shprt/sh/evaluate_batch.h"
#include "shprt/sh/evaluation_kernel.h"

namespace shprt {
namespace {

// Writes whole vectors into rows that are `stride` apart.
template <int kVectors>
struct RowSink {
  float* first;
  std::size_t stride;

  SHPRT_INLINE void tell(int i, const Lanes (&a)[kVectors], const Lanes (&b)[kVectors]) {
    float* to = first + static_cast<std::size_t>(i) * stride;
    SHPRT_UNROLL for (int v = 0; v < kVectors; ++v) storeLanes(a[v] * b[v], to + v * kLanes);
  }
};

// Writes the first `count` lanes only, for batches shorter than a vector.
struct PartialRowSink {
  float* first;
  std::size_t stride, count;

  SHPRT_INLINE void tell(int i, const Lanes (&a)[1], const Lanes (&b)[1]) {
    const Lanes values = a[0] * b[0];
    float* to = first + static_cast<std::size_t>(i) * stride;
    for (std::size_t lane = 0; lane < count; ++lane) to[lane] = values[lane];
  }
};

template <int kDegree, int kVectors, typename Sink>
SHPRT_INLINE void evaluateRows(const EvaluationTables& tables, int degree, const float* x, const float* y,
                               const float* z, Sink sink) {
  Directions<kVectors> u;
  prepare(x, y, z, u);
  SHPRT_UNROLL for (int v = 0; v < kVectors; ++v) {
    u.weight[v] = Lanes{} + 1.0f;
    u.floor[v] = Lanes{} + kFloor;
  }
  evaluateVectors<kDegree>(tables, degree, u, sink);
}

template <int kDegree>
SHPRT_INLINE void evaluateFew(const EvaluationTables& tables, int degree, const float* x, const float* y,
                              const float* z, std::size_t count, float* results, std::size_t stride) {
  float px[kLanes] = {}, py[kLanes] = {}, pz[kLanes] = {};
  for (std::size_t k = 0; k < count; ++k) {
    px[k] = x[k];
    py[k] = y[k];
    pz[k] = z[k];
  }
  evaluateRows<kDegree, 1>(tables, degree, px, py, pz, PartialRowSink{results, stride, count});
}

template <int kVectors>
SHPRT_INLINE void evaluateBatch(int degree, const float* x, const float* y, const float* z, std::size_t count,
                                float* results, std::size_t stride) {
  const EvaluationTables& tables = evaluationTables();
  withDegree(degree, [&]<int kDegree>() {
    constexpr std::size_t kStep = kVectors * kLanes;
    if (count < kLanes) {
      evaluateFew<kDegree>(tables, degree, x, y, z, count, results, stride);
      return;
    }
    std::size_t k = 0;
    for (; k + kStep <= count; k += kStep)
      evaluateRows<kDegree, kVectors>(tables, degree, x + k, y + k, z + k,
                                      RowSink<kVectors>{results + k, stride});
    while (k < count) {
      // The last vector may repeat lanes of the one before: it writes the same values.
      const std::size_t begin = k + kLanes <= count ? k : count - kLanes;
      evaluateRows<kDegree, 1>(tables, degree, x + begin, y + begin, z + begin,
                               RowSink<1>{results + begin, stride});
      k = begin + kLanes;
    }
  });
}

}  // namespace
}  // namespace shprt
