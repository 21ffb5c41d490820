// accumulateSh for any processor.
#include "shprt/sh/accumulate_variants.h"

#define SHPRT_LANES 4
#include "shprt/sh/accumulate_kernel.h"

namespace shprt {

void accumulateShBaseline(int degree, const float* x, const float* y, const float* z, const float* weight,
                          std::size_t count, double* sums) {
  accumulateKernel<2>(degree, x, y, z, weight, count, sums);
}

}  // namespace shprt
