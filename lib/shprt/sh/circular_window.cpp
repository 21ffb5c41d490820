// Band factors of a circular window, f_l = 1/(1-z) integral_z^1 P_l(t) dt with z = cos(radius).
//
// As (1-z^2) P_l'(z) = l(l+1) integral_z^1 P_l dt, f_l = cos^2(radius/2) Q_l with Q_l = 2 P_l' / (l(l+1)),
// which is 1 at z = 1. The recurrence (l+2) Q_{l+1} = (2l+1) z Q_l - (l-1) Q_{l-1} is that of Lisle and Huang
// 2007, eq. 11, for f_l; there z close to 1 loses the window's radius. Written for the differences D_l = Q_l
// - Q_{l-1}, with delta = 1 - z = 2 sin^2(radius/2), it keeps it:
//   D_{l+1} = ((l-1) D_l - (2l+1) delta Q_l) / (l+2),   Q_{l+1} = Q_l + D_{l+1},   Q_1 = 1, D_1 = 0.
// Beyond a hemisphere the complement has the same Q_l up to the sign (-1)^(l+1), as P_l integrates to zero.

#include "shprt/sh/circular_window.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "shprt/base/error.h"

namespace shprt {

std::vector<double> circularWindowFactors(int degree, double radius) {
  assert(degree >= 0);
  if (!(radius > 0 && radius <= std::numbers::pi))
    throw Error("circular window", "the radius of " + std::to_string(radius) + " radians is out of range",
                "give more than 0 and at most pi");
  std::vector<double> factors(static_cast<std::size_t>(degree) + 1, 1.0);
  const double sine = std::sin(radius / 2), cosine = std::cos(radius / 2);
  const bool wide = sine > cosine;
  const double delta = 2 * (wide ? cosine * cosine : sine * sine);
  double difference = 0, quotient = 1;
  for (std::size_t l = 1; l < factors.size(); ++l) {
    const auto order = static_cast<double>(l);
    factors[l] = cosine * cosine * (wide && l % 2 == 0 ? -quotient : quotient);
    difference = ((order - 1) * difference - (2 * order + 1) * delta * quotient) / (order + 2);
    quotient += difference;
  }
  return factors;
}

double circularWindowSolidAngle(double radius) {
  const double sine = std::sin(radius / 2);
  return 4 * std::numbers::pi * sine * sine;
}

}  // namespace shprt
