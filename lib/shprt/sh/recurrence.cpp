#include "shprt/sh/recurrence.h"

#include "shprt/sh/basis.h"

namespace shprt {

const RecurrenceTable& recurrenceTable() {
  static const RecurrenceTable table = [] {
    RecurrenceTable t{2 * kMaximumBakeDegree, {kY00}, {}};
    for (int m = 0; m <= t.degree; ++m) {
      if (m > 0) t.sectoral.push_back(sectoralFactor(m));
      for (int l = m + 1; l <= t.degree; ++l) t.steps.push_back(differenceStep(l, m));
    }
    return t;
  }();
  return table;
}

}  // namespace shprt
