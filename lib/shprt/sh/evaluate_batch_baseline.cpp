// evaluateShBatch for any processor.
#include "shprt/sh/evaluate_batch_variants.h"

#define SHPRT_LANES 4
#include "shprt/sh/evaluate_batch_kernel.h"

namespace shprt {

void evaluateShBatchBaseline(int degree, const float* x, const float* y, const float* z, std::size_t count,
                             float* results, std::size_t stride) {
  evaluateBatch<4>(degree, x, y, z, count, results, stride);
}

}  // namespace shprt
