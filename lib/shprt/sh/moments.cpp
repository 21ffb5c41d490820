// A point of light in direction n, with average 1, has the band sums 1, 3 n.w and 5 P_2(n.w) = 15/2 ((n.w)^2
// - 1/3); as every function is a sum of such points, 3 and 15/2 are the factors of reconstruction. The
// factors to orthonormal coefficients follow from y_1 = sqrt(3/4pi) (y, z, x) and y_2 = sqrt(15/4pi) (xy, yz,
// sqrt(3)/2 (z^2 - 1/3), xz, (x^2 - y^2)/2) by integrating over the sphere's 4 pi.

#include "shprt/sh/moments.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "shprt/sh/basis.h"

namespace shprt {
namespace {

using std::numbers::pi;

const double kMean = std::sqrt(4 * pi), kVector = std::sqrt(12 * pi), kProduct = std::sqrt(60 * pi),
             kPolar = std::sqrt(45 * pi), kDifference = std::sqrt(15 * pi);

}  // namespace

Moments momentsOf(std::span<const double> c) {
  assert(c.size() == 1 || c.size() == 4 || c.size() == 9);
  Moments moments;
  moments.mean = c[0] / kMean;
  if (c.size() < 4) return moments;
  moments.vector = Vec3d{c[3], c[1], c[2]} / kVector;
  if (c.size() < 9) return moments;
  const double xy = c[4] / kProduct, yz = c[5] / kProduct, xz = c[7] / kProduct, zz = c[6] / kPolar,
               difference = c[8] / kDifference;
  moments.matrix = {{{(difference - zz) / 2, xy, xz}, {xy, (-difference - zz) / 2, yz}, {xz, yz, zz}}};
  return moments;
}

std::vector<double> coefficientsOf(const Moments& moments, int degree) {
  assert(degree >= 0 && degree <= 2);
  const auto& m = moments.matrix.m;
  const double third = (m[0][0] + m[1][1] + m[2][2]) / 3;
  std::vector<double> c = {
      kMean * moments.mean,       kVector * moments.vector.y, kVector * moments.vector.z,
      kVector * moments.vector.x, kProduct * m[0][1],         kProduct * m[1][2],
      kPolar * (m[2][2] - third), kProduct * m[0][2],         kDifference * (m[0][0] - m[1][1])};
  c.resize(static_cast<std::size_t>(coefficientCount(degree)));
  return c;
}

double evaluateMoments(const Moments& moments, Vec3d direction) {
  return moments.mean + 3 * dot(moments.vector, direction) + 7.5 * dot(direction, moments.matrix * direction);
}

Moments transformMoments(const Moments& moments, const Mat3& q) {
  return {moments.mean, q * moments.vector, q * moments.matrix * transpose(q)};
}

}  // namespace shprt
