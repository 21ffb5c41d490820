// What storage as 16-bit half does to a number.
#pragma once

#include <algorithm>
#include <cmath>

namespace shprt {

// The nearest number with 11 significant bits, ties to even, spaced no closer than 2^-24: what an IEEE half
// holds. |value| at most 65504.
inline float roundToHalf(float value) {
  if (value == 0) return value;
  const double exact = static_cast<double>(value);
  const double spacing = std::ldexp(1.0, std::max(std::ilogb(exact), -14) - 10);
  return static_cast<float>(std::nearbyint(exact / spacing) * spacing);
}

}  // namespace shprt
