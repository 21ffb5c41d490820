// With R = u x grad, the generator of rotations about the three axes, grad y = (R y) x u on the sphere. R
// leaves a band to itself: R_z turns y_{l,m} into -m y_{l,-m}, and R_x, R_y combine the orders m - 1 and m +
// 1 of the same band, with the factors sqrt((l-m)(l+m+1)) of the ladder operators of angular momentum. So
// gradients are as exact as values, and need neither a second recurrence nor a division by sin(theta).

#include "shprt/sh/gradient.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "shprt/sh/basis.h"

namespace shprt {

void evaluateShGradient(int degree, Vec3d direction, std::span<double> values, std::span<Vec3d> gradients) {
  assert(gradients.size() >= static_cast<std::size_t>(coefficientCount(degree)));
  evaluateSh(degree, direction, values);
  const Vec3d u = normalize(direction);
  for (int l = 0; l <= degree; ++l) {
    const double* y = values.data() + shIndex(l, 0);
    Vec3d* gradient = gradients.data() + shIndex(l, 0);
    double below = 0;  // half the factor between orders m - 1 and m
    for (int m = 0; m <= l; ++m) {
      const double above = 0.5 * std::sqrt(static_cast<double>(l - m) * (l + m + 1));
      const double cosAbove = m < l ? above * y[m + 1] : 0, sinAbove = m < l ? above * y[-m - 1] : 0;
      if (m == 0) {
        // Both neighbours of order 0 are order 1.
        gradient[0] = cross({std::numbers::sqrt2 * sinAbove, -std::numbers::sqrt2 * cosAbove, 0}, u);
      } else {
        const double cosBelow = below * y[m - 1] * (m == 1 ? std::numbers::sqrt2 : 1);
        const double sinBelow = m == 1 ? 0 : below * y[1 - m];
        gradient[m] = cross({sinAbove + sinBelow, cosBelow - cosAbove, -m * y[-m]}, u);
        gradient[-m] = cross({-cosAbove - cosBelow, sinBelow - sinAbove, m * y[m]}, u);
      }
      below = above;
    }
  }
}

}  // namespace shprt
