// Rotation matrices from what describes them, and the nearest rotation to a matrix. Based on: the Newton-
// Schulz iteration X <- X + X (1 - X^T X) / 2, which converges quadratically to the orthogonal polar factor
// of X, the nearest orthogonal matrix.

#include <algorithm>
#include <cmath>
#include <string>

#include "shprt/base/error.h"
#include "shprt/sh/rotation.h"

namespace shprt {
namespace {

// 1 - X^T X, and its largest entry.
struct Defect {
  Mat3 matrix;
  double largest = 0;
};

Defect orthogonalityDefect(const Mat3& a) {
  Defect defect;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      const double product = a.m[0][i] * a.m[0][j] + a.m[1][i] * a.m[1][j] + a.m[2][i] * a.m[2][j];
      const double off = (i == j ? 1 : 0) - product;
      defect.matrix.m[i][j] = defect.matrix.m[j][i] = off;
      if (!(std::abs(off) <= defect.largest)) defect.largest = std::abs(off);
    }
  return defect;
}

constexpr double kLargestDefect = 2e-3;
// A matrix whose entries are rounded to double has no less.
constexpr double kRoundingDefect = 1e-15;

}  // namespace

NearestRotation nearestRotation(const Mat3& matrix) {
  const char* const remedy = "give orthonormal rows and determinant +1";
  for (const auto& row : matrix.m)
    if (!std::isfinite(row[0]) || !std::isfinite(row[1]) || !std::isfinite(row[2]))
      throw Error("rotation", "the matrix has an entry that is not a finite number", remedy);
  Defect defect = orthogonalityDefect(matrix);
  if (!(defect.largest <= kLargestDefect))
    throw Error("rotation", "the matrix is no rotation (it scales or shears)", remedy);
  if (determinant(matrix) < 0) throw Error("rotation", "the matrix is a reflection", remedy);
  NearestRotation nearest{matrix, 0};
  // 2e-3 becomes 3e-6, 7e-12, 4e-23.
  for (int step = 0; step < 3 && defect.largest > kRoundingDefect; ++step) {
    const Mat3 change = nearest.rotation * defect.matrix;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        double& entry = nearest.rotation.m[i][j];
        entry += change.m[i][j] / 2;
      }
    defect = orthogonalityDefect(nearest.rotation);
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      nearest.correction = std::max(nearest.correction, std::abs(nearest.rotation.m[i][j] - matrix.m[i][j]));
  return nearest;
}

Mat3 rotationFromQuaternion(double w, double x, double y, double z) {
  const double largest = std::max(std::max(std::abs(w), std::abs(x)), std::max(std::abs(y), std::abs(z)));
  if (!std::isfinite(w) || !std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z) || largest == 0)
    throw Error("rotation", largest == 0 ? "the quaternion is zero" : "the quaternion is not finite",
                "give four finite numbers w, x, y, z that are not all zero");
  // Scaled first, so that squares stay in range; 2 / norm^2 then saves the square root.
  w /= largest, x /= largest, y /= largest, z /= largest;
  const double twice = 2 / (w * w + x * x + y * y + z * z);
  return {{{1 - twice * (y * y + z * z), twice * (x * y - w * z), twice * (x * z + w * y)},
           {twice * (x * y + w * z), 1 - twice * (x * x + z * z), twice * (y * z - w * x)},
           {twice * (x * z - w * y), twice * (y * z + w * x), 1 - twice * (x * x + y * y)}}};
}

Mat3 rotationFromEulerZyz(double alpha, double beta, double gamma) {
  if (!std::isfinite(alpha) || !std::isfinite(beta) || !std::isfinite(gamma))
    throw Error("rotation", "an Euler angle is not finite", "give three finite angles");
  const double ca = std::cos(alpha), sa = std::sin(alpha), cb = std::cos(beta), sb = std::sin(beta);
  const double cc = std::cos(gamma), sc = std::sin(gamma);
  return {{{ca * cb * cc - sa * sc, -ca * cb * sc - sa * cc, ca * sb},
           {sa * cb * cc + ca * sc, -sa * cb * sc + ca * cc, sa * sb},
           {-sb * cc, sb * sc, cb}}};
}

}  // namespace shprt
