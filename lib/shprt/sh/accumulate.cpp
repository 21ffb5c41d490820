#include "shprt/sh/accumulate.h"

#include <cassert>
#include <vector>

#include "shprt/sh/accumulate_variants.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/processor.h"

namespace shprt {

std::span<const AccumulateVariant> accumulateVariants() {
  static const std::vector<AccumulateVariant> variants = [] {
    std::vector<AccumulateVariant> v;
#if defined(__x86_64__)
    if (hasAvx512()) v.push_back({"AVX-512", accumulateShAvx512});
    if (hasAvx2()) v.push_back({"AVX2", accumulateShAvx2});
#endif
    v.push_back({"baseline", accumulateShBaseline});
    return v;
  }();
  return variants;
}

void accumulateSh(int degree, const float* x, const float* y, const float* z, const float* weight,
                  std::size_t count, double* sums) {
  assert(degree >= 0 && degree <= kMaximumBakeDegree && count % kAccumulateLanes == 0);
  static const AccumulateFunction function = accumulateVariants().front().function;
  function(degree, x, y, z, weight, count, sums);
}

}  // namespace shprt
