// Rotation by Euler angles: turns about z are a 2x2 rotation of each pair (m, -m); the turn about y is dense
// within a band. Its Wigner matrices d^l(beta) come from Risbo's recursion, which climbs from spin j to j +
// 1/2 by four products with factors of at most one, so errors do not grow with l as they do in recurrences
// across bands (shared findings: 1.4e-14 at l = 200). Based on: Risbo 1996, eqs. 5-6 (recursion in j); real
// form from y_m = (Z^m + Z^-m)/sqrt(2), y_-m = (Z^m - Z^-m)/(i sqrt(2)) with Z^m the complex harmonics
// without Condon-Shortley phase.

#include "shprt/sh/rotation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "shprt/base/error.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

// The matrices d^j(beta) for j = 0, 1/2, 1, ...: entry (i, k) stands for m' = i - j, m = k - j.
class WignerBands {
 public:
  explicit WignerBands(double beta) : cosine_(std::cos(beta / 2)), sine_(std::sin(beta / 2)), entries_{1.0} {}

  // From band l to band l + 1.
  void climb() {
    halfStep();
    halfStep();
  }
  double at(int l, int m1, int m2) const {
    return entries_[static_cast<std::size_t>((m1 + l) * (2 * l + 1) + m2 + l)];
  }

 private:
  void halfStep() {
    const int n = ++twiceJ_;
    std::vector<double> next(static_cast<std::size_t>((n + 1) * (n + 1)), 0.0);
    std::vector<double> root(static_cast<std::size_t>(n) + 1);
    for (int i = 0; i <= n; ++i) root[static_cast<std::size_t>(i)] = std::sqrt(static_cast<double>(i));
    const auto rootOf = [&](int i) { return root[static_cast<std::size_t>(i)]; };
    const auto slot = [&](int i, int k) -> double& {
      return next[static_cast<std::size_t>(i * (n + 1) + k)];
    };
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        const double d = entries_[static_cast<std::size_t>(i * n + k)] / n;
        slot(i, k) += rootOf(n - i) * rootOf(n - k) * cosine_ * d;
        slot(i + 1, k) -= rootOf(i + 1) * rootOf(n - k) * sine_ * d;
        slot(i, k + 1) += rootOf(n - i) * rootOf(k + 1) * sine_ * d;
        slot(i + 1, k + 1) += rootOf(i + 1) * rootOf(k + 1) * cosine_ * d;
      }
    entries_ = std::move(next);
  }

  double cosine_, sine_;
  int twiceJ_ = 0;
  std::vector<double> entries_;
};

// Turns one band about z. band points at its m = 0 entry.
void turnAboutZ(int l, double angle, double* band) {
  for (int m = 1; m <= l; ++m) {
    const double c = std::cos(m * angle), s = std::sin(m * angle);
    const double plus = band[m], minus = band[-m];
    band[m] = c * plus - s * minus;
    band[-m] = s * plus + c * minus;
  }
}

// The real matrix of a turn about y: cosines and sines do not mix.
class RealTurnAboutY {
 public:
  RealTurnAboutY(int l, const WignerBands& bands)
      : l_(l), cosines_(size() * size()), sines_(cosines_.size()) {
    for (int m = 0; m <= l; ++m)
      for (int n = 0; n <= l; ++n) {
        const double same = ((m + n) % 2 ? -1 : 1) * bands.at(l, m, n);
        const double opposite = (m % 2 ? -1 : 1) * bands.at(l, m, -n);
        const double norm = m == 0 && n == 0 ? 0.5 : m == 0 || n == 0 ? std::numbers::sqrt2 / 2 : 1;
        cosines_[index(m, n)] = norm * (same + opposite);
        sines_[index(m, n)] = same - opposite;
      }
  }

  void apply(double* band, std::vector<double>& scratch) const {
    scratch.assign(2 * size() - 1, 0.0);
    double* turned = scratch.data() + l_;
    for (int m = 0; m <= l_; ++m) {
      double cosine = 0, sine = 0;
      for (int n = 0; n <= l_; ++n) {
        cosine += cosines_[index(m, n)] * band[n];
        sine += n > 0 ? sines_[index(m, n)] * band[-n] : 0;
      }
      turned[m] = cosine;
      if (m > 0) turned[-m] = sine;
    }
    std::copy(scratch.begin(), scratch.end(), band - l_);
  }

 private:
  std::size_t size() const { return static_cast<std::size_t>(l_) + 1; }
  std::size_t index(int m, int n) const {
    return static_cast<std::size_t>(m) * size() + static_cast<std::size_t>(n);
  }

  int l_;
  std::vector<double> cosines_, sines_;
};

Mat3 inverseTranspose(const Mat3& a) {
  const double d = determinant(a);
  Mat3 cofactors;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      cofactors.m[i][j] = (a.m[i1][j1] * a.m[i2][j2] - a.m[i1][j2] * a.m[i2][j1]) / d;
    }
  return cofactors;
}

}  // namespace

NearestRotation nearestRotation(const Mat3& matrix) {
  const std::string remedy = "give orthonormal rows and determinant +1";
  double defect = 0;
  const Mat3 product = transpose(matrix) * matrix;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (!std::isfinite(matrix.m[i][j]))
        throw Error("rotation", "the matrix has an entry that is not a finite number", remedy);
      defect = std::max(defect, std::abs(product.m[i][j] - (i == j ? 1 : 0)));
    }
  if (defect > 2e-3) throw Error("rotation", "the matrix is no rotation (it scales or shears)", remedy);
  if (determinant(matrix) < 0) throw Error("rotation", "the matrix is a reflection", remedy);
  // Newton's iteration for the polar factor converges quadratically; five steps from 2e-3 are more than
  // enough.
  NearestRotation nearest{matrix, 0};
  for (int step = 0; step < 5; ++step) {
    const Mat3 other = inverseTranspose(nearest.rotation);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) nearest.rotation.m[i][j] = (nearest.rotation.m[i][j] + other.m[i][j]) / 2;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      nearest.correction = std::max(nearest.correction, std::abs(nearest.rotation.m[i][j] - matrix.m[i][j]));
  return nearest;
}

ShRotation::ShRotation(int degree, const Mat3& matrix) : degree_(degree) {
  assert(degree >= 0);
  const auto& r = nearestRotation(matrix).rotation.m;
  // Each angle is taken from entries that determine it even where the others are lost (gimbal lock).
  beta_ = std::atan2(std::hypot(r[0][2], r[1][2]), r[2][2]);
  alpha_ = std::atan2(r[1][2], r[0][2]);
  const double s = std::sin(alpha_), c = std::cos(alpha_);
  gamma_ = std::atan2(c * r[1][0] - s * r[0][0], c * r[1][1] - s * r[0][1]);
}

void ShRotation::apply(std::span<const std::span<double>> sets) const {
  WignerBands bands(beta_);
  std::vector<double> scratch;
  for (int l = 1; l <= degree_; ++l) {
    bands.climb();
    const RealTurnAboutY turn(l, bands);
    for (const std::span<double> set : sets) {
      assert(set.size() == static_cast<std::size_t>(coefficientCount(degree_)));
      double* band = set.data() + shIndex(l, 0);
      turnAboutZ(l, gamma_, band);
      turn.apply(band, scratch);
      turnAboutZ(l, alpha_, band);
    }
  }
}

}  // namespace shprt
