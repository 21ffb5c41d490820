#include "shprt/sh/accumulate.h"

#include <array>
#include <cassert>

#include "shprt/sh/accumulate_tables.h"
#include "shprt/sh/accumulate_variants.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/recurrence.h"

namespace shprt {

static_assert(kMaximumAccumulateCoefficients == coefficientCount(kMaximumBakeDegree));

const AccumulateTables& accumulateTables(int degree) {
  static const auto all = [] {
    std::array<AccumulateTables, kMaximumBakeDegree + 1> tables{};
    for (int d = 0; d <= kMaximumBakeDegree; ++d) {
      AccumulateTables& t = tables[static_cast<std::size_t>(d)];
      double sectoral = kY00;
      std::size_t next = 0;
      for (int m = 0; m <= d; ++m) {
        if (m > 0) sectoral *= sectoralFactor(m);
        t.sectoral[m] = static_cast<float>(sectoral);
        for (int l = m + 1; l <= d; ++l) {
          const Recurrence r = recurrence(l, m);
          t.constants[next++] = static_cast<float>(r.a);
          t.constants[next++] = static_cast<float>(r.a * r.b);
        }
      }
    }
    return tables;
  }();
  return all[static_cast<std::size_t>(degree)];
}

AccumulateVariant chooseAccumulateVariant() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return {"AVX-512", accumulateShAvx512};
#endif
  return {"baseline", accumulateShBaseline};
}

void accumulateSh(int degree, const float* x, const float* y, const float* z, const float* weight,
                  std::size_t count, double* sums) {
  assert(degree >= 0 && degree <= kMaximumBakeDegree && count % kAccumulateLanes == 0);
  static const AccumulateVariant variant = chooseAccumulateVariant();
  variant.function(degree, x, y, z, weight, count, sums);
}

}  // namespace shprt
