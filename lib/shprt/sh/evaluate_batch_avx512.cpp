// evaluateShBatch for processors with AVX-512.
#include "shprt/sh/evaluate_batch_variants.h"

#if defined(__x86_64__)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx512f,avx2,fma"))), apply_to = function)
#else
#pragma GCC target("avx512f,avx2,fma")
#endif
#define SHPRT_LANES 16
#include "shprt/sh/evaluate_batch_kernel.h"

namespace shprt {

void evaluateShBatchAvx512(int degree, const float* x, const float* y, const float* z, std::size_t count,
                           float* results, std::size_t stride) {
  evaluateBatch<4>(degree, x, y, z, count, results, stride);
}

}  // namespace shprt

#if defined(__clang__)
#pragma clang attribute pop
#endif
#endif
