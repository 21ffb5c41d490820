// Nodes by Newton's iteration on P_n(1 - x) in the distance x from the end of the interval: the recurrence
// for the differences E_l = P_l - P_{l-1}, (l+1) E_{l+1} = l E_l - (2l+1) x P_l, keeps the digits of x where
// the nodes crowd. It starts from the asymptotic angles pi (i + 3/4) / (n + 1/2), which are close enough for
// quadratic convergence at every n.

#include "shprt/sh/gauss_legendre.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace shprt {
namespace {

struct LegendrePair {
  double value, slope;  // P_n and dP_n / dz at z = 1 - x
};

LegendrePair legendreNearOne(int n, double x) {
  double difference = 0, value = 1;
  for (int l = 0; l < n; ++l) {
    difference = (l * difference - (2 * l + 1) * x * value) / (l + 1);
    value += difference;
  }
  // (1 - z^2) P_n' = n (P_{n-1} - z P_n), written with P_{n-1} = P_n - E_n.
  return {value, n * (x * value - difference) / (x * (2 - x))};
}

}  // namespace

GaussLegendreRule gaussLegendre(int count) {
  assert(count >= 1);
  const auto size = static_cast<std::size_t>(count);
  GaussLegendreRule rule{std::vector<double>(size), std::vector<double>(size)};
  for (std::size_t i = 0; i < (size + 1) / 2; ++i) {
    const double half = std::numbers::pi * (static_cast<double>(i) + 0.75) / (count + 0.5) / 2;
    double x = 2 * std::sin(half) * std::sin(half);
    LegendrePair p = legendreNearOne(count, x);
    for (int step = 0; step < 5; ++step) {
      x += p.value / p.slope;
      p = legendreNearOne(count, x);
    }
    const double node = 2 * i + 1 == size ? 0 : 1 - x;
    rule.nodes[size - 1 - i] = node;
    rule.nodes[i] = -node;
    rule.weights[i] = rule.weights[size - 1 - i] = 2 / (x * (2 - x) * p.slope * p.slope);
  }
  return rule;
}

}  // namespace shprt
