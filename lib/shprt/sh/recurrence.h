// Constants of the recurrences that evaluate spherical harmonics: Pi_lm = a (z Pi_{l-1,m} - b Pi_{l-2,m}).
// Based on: Holmes and Featherstone 2002, eqs. 11-12, with Pi_{m-1,m} = 0.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

inline constexpr double kY00 = 0.28209479177387814347;  // 1 / sqrt(4 pi)

struct Recurrence {
  double a, b;
};

// For l > m >= 0.
inline Recurrence recurrence(int l, int m) {
  const double lower = l - 1, squaredM = static_cast<double>(m) * m;
  return {std::sqrt((4.0 * l * l - 1) / (static_cast<double>(l) * l - squaredM)),
          std::sqrt((lower * lower - squaredM) / (4 * lower * lower - 1))};
}

// Pi_mm / Pi_{m-1,m-1}, for m >= 1. The first step carries the sqrt(2) of real harmonics.
inline double sectoralFactor(int m) {
  return std::sqrt((m == 1 ? 2.0 : 1.0) * (2.0 * m + 1) / (2.0 * m));
}

// The constants to a degree that covers stored coefficients; beyond, they are computed as they are needed.
struct RecurrenceTable {
  int degree;
  std::vector<Recurrence> constants;  // by l (l - 1) / 2 + m

  const Recurrence& at(int l, int m) const {
    return constants[static_cast<std::size_t>(l * (l - 1) / 2 + m)];
  }
};
const RecurrenceTable& recurrenceTable();

// z of a unit direction, recomputed from x and y where those hold it better: value + rest.
struct PolarHeight {
  double value, rest;
};
PolarHeight polarHeight(Vec3d direction);

}  // namespace shprt
