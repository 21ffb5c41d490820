// accumulateSh for processors with AVX2.
#include "shprt/sh/accumulate_variants.h"

#if defined(__x86_64__)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC target("avx2,fma")
#endif
#define SHPRT_LANES 8
#include "shprt/sh/accumulate_kernel.h"

namespace shprt {

void accumulateShAvx2(int degree, const float* x, const float* y, const float* z, const float* weight,
                      std::size_t count, double* sums) {
  accumulateKernel<4>(degree, x, y, z, weight, count, sums);
}

}  // namespace shprt

#if defined(__clang__)
#pragma clang attribute pop
#endif
#endif
