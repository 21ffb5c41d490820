#include "shprt/sh/evaluation_tables.h"

#include "shprt/sh/basis.h"
#include "shprt/sh/recurrence.h"

namespace shprt {

static_assert(kMaximumFloatDegree == kMaximumBakeDegree);

const EvaluationTables& evaluationTables() {
  static const EvaluationTables tables = [] {
    EvaluationTables t{};
    FloatStep* to = t.steps;
    double sectoral = kY00;
    for (int m = 0; m <= kMaximumFloatDegree; ++m) {
      if (m > 0) sectoral *= sectoralFactor(m);
      *to++ = {0, static_cast<float>(sectoral)};
      double norm = sectoral;
      for (int l = m + 1; l <= kMaximumFloatDegree; ++l) {
        const DifferenceStep step = differenceStep(l, m);
        norm *= step.growth;
        *to++ = {static_cast<float>(step.alpha), static_cast<float>(norm)};
      }
    }
    return t;
  }();
  return tables;
}

}  // namespace shprt
