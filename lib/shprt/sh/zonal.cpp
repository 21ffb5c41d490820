#include "shprt/sh/zonal.h"

#include <cstddef>
#include <numbers>

namespace shprt {

std::vector<double> clampedCosineFactors(int degree) {
  using std::numbers::pi;
  std::vector<double> factors(static_cast<std::size_t>(degree) + 1, 0.0);
  factors[0] = pi;
  if (degree >= 1) factors[1] = 2 * pi / 3;
  double binomial = 1;  // l! / (2^l (l/2)!^2)
  for (int l = 2; l <= degree; l += 2) {
    binomial *= (l - 1.0) / l;
    const double sign = l % 4 == 2 ? 1 : -1;
    factors[static_cast<std::size_t>(l)] = sign * 2 * pi * binomial / ((l + 2.0) * (l - 1.0));
  }
  return factors;
}

}  // namespace shprt
