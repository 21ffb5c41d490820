#include "shprt/sh/evaluate_batch.h"

#include <cassert>
#include <vector>

#include "shprt/sh/basis.h"
#include "shprt/sh/evaluate_batch_variants.h"
#include "shprt/sh/processor.h"

namespace shprt {

std::span<const EvaluateBatchVariant> evaluateBatchVariants() {
  static const std::vector<EvaluateBatchVariant> variants = [] {
    std::vector<EvaluateBatchVariant> v;
#if defined(__x86_64__)
    if (hasAvx512()) v.push_back({"AVX-512", evaluateShBatchAvx512});
    if (hasAvx2()) v.push_back({"AVX2", evaluateShBatchAvx2});
#endif
    v.push_back({"baseline", evaluateShBatchBaseline});
    return v;
  }();
  return variants;
}

void evaluateShBatch(int degree, const float* x, const float* y, const float* z, std::size_t count,
                     float* results, std::size_t stride) {
  assert(degree >= 0 && degree <= kMaximumBakeDegree && stride >= count);
  static const EvaluateBatchFunction function = evaluateBatchVariants().front().function;
  function(degree, x, y, z, count, results, stride);
}

}  // namespace shprt
