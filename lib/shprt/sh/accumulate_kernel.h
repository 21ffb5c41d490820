// The body of accumulateSh, compiled once for each instruction set by the files that include it. It uses the
// compiler's vector types only and no library function, so that no code for a newer processor can leak out.
// Scalar twin and reference: evaluateSh.

#include "shprt/sh/accumulate.h"
#include "shprt/sh/accumulate_tables.h"

namespace shprt {
namespace {

using Lanes = float __attribute__((vector_size(64)));

// Lane sums of one coefficient into a double, in a fixed order.
inline double foldLanes(const Lanes& lanes) {
  double sum = 0;
  for (int lane = 0; lane < 16; ++lane) sum += static_cast<double>(lanes[lane]);
  return sum;
}

// Vectors travel by reference: passed by value they would have another ABI in each variant.
inline void loadLanes(const float* from, Lanes& lanes) {
  __builtin_memcpy(&lanes, from, sizeof lanes);
}

// sums[i] += weight * y_i for one block of 16 directions.
inline void addBlock(const AccumulateTables& tables, int degree, const Lanes& x, const Lanes& y,
                     const Lanes& z, const Lanes& weight, Lanes* sums) {
  const float* constants = tables.constants;
  Lanes powerRe = weight, powerIm = weight * 0.0f;  // weight * (x + iy)^m
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) {
      const Lanes next = powerRe * x - powerIm * y;
      powerIm = powerRe * y + powerIm * x;
      powerRe = next;
    }
    Lanes previous = x * 0.0f;
    Lanes current = previous + tables.sectoral[m];
    for (int l = m;;) {
      const int centre = l * (l + 1);
      sums[centre + m] += current * powerRe;
      if (m > 0) sums[centre - m] += current * powerIm;
      if (++l > degree) break;
      const Lanes next = constants[0] * z * current - constants[1] * previous;
      constants += 2;
      previous = current;
      current = next;
    }
  }
}

inline void accumulateKernel(int degree, const float* x, const float* y, const float* z, const float* weight,
                             std::size_t count, double* sums) {
  constexpr std::size_t kBlocksPerFold = 16;
  const AccumulateTables& tables = accumulateTables(degree);
  const int coefficients = (degree + 1) * (degree + 1);
  Lanes lanes[kMaximumAccumulateCoefficients];
  for (int i = 0; i < coefficients; ++i) sums[i] = 0;
  for (std::size_t first = 0; first < count; first += 16 * kBlocksPerFold) {
    for (int i = 0; i < coefficients; ++i) lanes[i] = Lanes{};
    const std::size_t end = first + 16 * kBlocksPerFold < count ? first + 16 * kBlocksPerFold : count;
    for (std::size_t block = first; block < end; block += 16) {
      Lanes bx, by, bz, bw;
      loadLanes(x + block, bx);
      loadLanes(y + block, by);
      loadLanes(z + block, bz);
      loadLanes(weight + block, bw);
      const Lanes squared = bx * bx + by * by;
      // z from x and y near a pole, as polarHeight does.
      Lanes height;
      for (int lane = 0; lane < 16; ++lane) {
        const float up = __builtin_sqrtf(squared[lane] < 0.5f ? 1.0f - squared[lane] : bz[lane] * bz[lane]);
        height[lane] = bz[lane] < 0 ? -up : up;
      }
      addBlock(tables, degree, bx, by, height, bw, lanes);
    }
    for (int i = 0; i < coefficients; ++i) sums[i] += foldLanes(lanes[i]);
  }
}

}  // namespace
}  // namespace shprt
