// Integrals of Legendre polynomials in long double, as an independent expectation for tests of this room.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace shprt::test {

// P_0..P_degree at z = 1 - x, 0 <= x <= 2, by differences from 1, which keep the digits of a small x.
inline std::vector<long double> legendre(int degree, long double x) {
  const bool mirrored = x > 1;
  if (mirrored) x = 2 - x;
  std::vector<long double> values;
  long double difference = 0, value = 1;
  for (int l = 0; l <= degree; ++l) {
    values.push_back(mirrored && l % 2 ? -value : value);
    difference = (l * difference - (2 * l + 1) * x * value) / (l + 1);
    value += difference;
  }
  return values;
}

struct UnitRule {
  std::vector<long double> nodes, weights;  // Gauss-Legendre on [0, 1]
};

inline UnitRule unitRule(int count) {
  UnitRule rule;
  for (int i = 0; i < count; ++i) {
    long double x = 1 - std::cos(std::numbers::pi_v<long double> * (i + 0.75L) / (count + 0.5L)), slope = 0;
    for (int step = 0; step < 6; ++step) {
      const std::vector<long double> p = legendre(count, x);
      const auto n = static_cast<std::size_t>(count);
      slope = count * (p[n - 1] - (1 - x) * p[n]) / (x * (2 - x));
      if (step < 5) x += p[n] / slope;
    }
    rule.nodes.push_back(x / 2);
    rule.weights.push_back(1 / (x * (2 - x) * slope * slope));
  }
  return rule;
}

}  // namespace shprt::test
