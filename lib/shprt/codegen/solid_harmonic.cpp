#include "shprt/codegen/solid_harmonic.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace shprt {

std::vector<double> solidHarmonic(int l, int m) {
  m = std::abs(m);
  assert(m <= l && l <= 32);
  // c_0 = sqrt((2 - [m = 0]) (2l+1)/4pi (l+m)!/(l-m)!) / (2^m m!), each factor of the quotients in turn.
  long double squared = (m == 0 ? 1 : 2) * (2 * l + 1) / (4 * std::numbers::pi_v<long double>);
  for (int i = 1; i <= m; ++i)
    squared *= static_cast<long double>((l + i) * (l - i + 1)) / static_cast<long double>(4 * i * i);
  long double coefficient = std::sqrt(squared);
  std::vector<double> coefficients;
  const int n = l - m;
  for (int k = 0;; ++k) {
    coefficients.push_back(static_cast<double>(coefficient));
    if (2 * (k + 1) > n) break;
    coefficient *= -static_cast<long double>((n - 2 * k) * (n - 2 * k - 1)) /
                   static_cast<long double>(4 * (k + 1) * (k + 1 + m));
  }
  return coefficients;
}

}  // namespace shprt
