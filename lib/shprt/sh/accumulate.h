// The inner loop of baking: weighted sums of the basis over many directions, in float lanes.
#pragma once

#include <cstddef>

namespace shprt {

inline constexpr std::size_t kAccumulateLanes = 16;

// sums[i] = sum over k < count of weight[k] * y_i(x[k], y[k], z[k]) for all i < coefficientCount(degree);
// what sums held before is overwritten. Directions are unit to float; count is a multiple of
// kAccumulateLanes; degree at most kMaximumBakeDegree. Values are computed in float: error at most (1e-6 +
// 4e-8 l^2) sqrt((2l+1)/4pi) each, the second term being the rounding of z beside a pole. Each lane adds at
// most 16 of them in float before it is folded into doubles, in an order that depends on count alone. Chooses
// AVX-512 or baseline code by what the processor has (a variant for AVX2 came out slower than the baseline:
// 64-byte vectors do not fit its registers).
void accumulateSh(int degree, const float* x, const float* y, const float* z, const float* weight,
                  std::size_t count, double* sums);

}  // namespace shprt
