// accumulateSh for processors with AVX-512.
#include "shprt/sh/accumulate_variants.h"

#if defined(__x86_64__)
#pragma GCC target("avx512f,avx2,fma")
#include "shprt/sh/accumulate_kernel.h"

namespace shprt {

void accumulateShAvx512(int degree, const float* x, const float* y, const float* z, const float* weight,
                        std::size_t count, double* sums) {
  accumulateKernel(degree, x, y, z, weight, count, sums);
}

}  // namespace shprt

#endif
