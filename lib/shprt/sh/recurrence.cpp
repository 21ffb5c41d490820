#include "shprt/sh/recurrence.h"

#include "shprt/sh/basis.h"

namespace shprt {

const RecurrenceTable& recurrenceTable() {
  static const RecurrenceTable table = [] {
    RecurrenceTable t{2 * kMaximumBakeDegree, {}};
    for (int l = 1; l <= t.degree; ++l)
      for (int m = 0; m < l; ++m) t.constants.push_back(recurrence(l, m));
    return t;
  }();
  return table;
}

}  // namespace shprt
