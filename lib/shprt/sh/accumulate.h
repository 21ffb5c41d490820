// The inner loop of baking: weighted sums of the basis over many directions, in float lanes.
#pragma once

#include <cstddef>

namespace shprt {

inline constexpr std::size_t kAccumulateLanes = 16;

// sums[i] = sum over k < count of weight[k] * y_i(x[k], y[k], z[k]) for all i < coefficientCount(degree);
// what sums held before is overwritten. Directions are unit to float; count is a multiple of
// kAccumulateLanes; degree at most kMaximumBakeDegree. Values are those of evaluateShBatch, in float: error
// at most 5e-7 sqrt((2l+1)/4pi) each when degree <= 8, 2e-6 to 32, poles included. Each lane adds at most 16
// of them in float before it is folded into doubles, in an order that depends on count alone. Chooses
// AVX-512, AVX2 or baseline code by what the processor has.
void accumulateSh(int degree, const float* x, const float* y, const float* z, const float* weight,
                  std::size_t count, double* sums);

}  // namespace shprt
