// Wigner matrices by other methods, to compare with: Risbo's recursion in extended precision as a reference,
// and two published recurrences across bands that lose digits as bands rise. All in this project's basis,
// (2l+1)^2 entries in row-major order.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt::test {

// A square matrix with rows and columns -l..l.
template <typename Number>
class BandMatrix {
 public:
  explicit BandMatrix(int l) : l_(l), entries_(static_cast<std::size_t>((2 * l + 1) * (2 * l + 1))) {}
  Number& operator()(int m, int n) {
    return entries_[static_cast<std::size_t>((m + l_) * (2 * l_ + 1) + n + l_)];
  }
  Number operator()(int m, int n) const {
    return entries_[static_cast<std::size_t>((m + l_) * (2 * l_ + 1) + n + l_)];
  }
  const std::vector<Number>& entries() const { return entries_; }

 private:
  int l_;
  std::vector<Number> entries_;
};

// Based on: Risbo 1996 (recursion in j): d^j(beta) from d^(j-1/2)(beta). Cosines and sines of the real basis
// are sums and differences of d_mn and d_m,-n. The angles are those of the matrix, R = Rz(alpha) Ry(beta)
// Rz(gamma).
inline std::vector<double> referenceWigner(int l, const Mat3& rotation) {
  using Real = long double;
  const auto& r = rotation.m;
  const Real tilt = std::hypot(Real{r[0][2]}, Real{r[1][2]}), beta = std::atan2(tilt, Real{r[2][2]});
  const Real alpha = std::atan2(Real{r[1][2]}, Real{r[0][2]}), sa = std::sin(alpha), ca = std::cos(alpha);
  const Real gamma = std::atan2(ca * r[1][0] - sa * r[0][0], ca * r[1][1] - sa * r[0][1]);
  const Real cosine = std::cos(beta / 2), sine = std::sin(beta / 2);
  std::vector<Real> d = {1};
  for (int n = 1; n <= 2 * l; ++n) {
    std::vector<Real> next(static_cast<std::size_t>((n + 1) * (n + 1)));
    std::vector<Real> root(static_cast<std::size_t>(n) + 1);
    for (int i = 0; i <= n; ++i) root[static_cast<std::size_t>(i)] = std::sqrt(static_cast<Real>(i));
    const auto rootOf = [&](int i) { return root[static_cast<std::size_t>(i)]; };
    const auto slot = [&](int i, int k) -> Real& { return next[static_cast<std::size_t>(i * (n + 1) + k)]; };
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        const Real entry = d[static_cast<std::size_t>(i * n + k)] / n;
        slot(i, k) += rootOf(n - i) * rootOf(n - k) * cosine * entry;
        slot(i + 1, k) -= rootOf(i + 1) * rootOf(n - k) * sine * entry;
        slot(i, k + 1) += rootOf(n - i) * rootOf(k + 1) * sine * entry;
        slot(i + 1, k + 1) += rootOf(i + 1) * rootOf(k + 1) * cosine * entry;
      }
    d = std::move(next);
  }
  const auto at = [&](int m, int n) { return d[static_cast<std::size_t>((m + l) * (2 * l + 1) + n + l)]; };
  BandMatrix<double> result(l);
  for (int m = 0; m <= l; ++m)
    for (int n = 0; n <= l; ++n) {
      const Real same = ((m + n) % 2 ? -1 : 1) * at(m, n), opposite = (m % 2 ? -1 : 1) * at(m, -n);
      const Real norm = m == 0 && n == 0 ? 0.5L : m == 0 || n == 0 ? std::sqrt(0.5L) : 1;
      const Real c = norm * (same + opposite), s = m > 0 && n > 0 ? same - opposite : 0;
      const Real cm = std::cos(m * alpha), sm = std::sin(m * alpha);
      const Real cn = std::cos(n * gamma), sn = std::sin(n * gamma);
      result(m, n) = static_cast<double>(cm * c * cn - sm * s * sn);
      if (n > 0) result(m, -n) = static_cast<double>(-cm * c * sn - sm * s * cn);
      if (m > 0) result(-m, n) = static_cast<double>(sm * c * cn + cm * s * sn);
      if (m > 0 && n > 0) result(-m, -n) = static_cast<double>(-sm * c * sn + cm * s * cn);
    }
  return result.entries();
}

// Based on: Ivanic and Ruedenberg 1996 with the corrections of 1998: every band from the one
// below and band 1.
inline std::vector<double> ivanicRuedenbergWigner(int degree, const Mat3& rotation) {
  constexpr std::array<int, 3> kAxisOf = {1, 2, 0};  // m = -1, 0, 1 are y, z, x
  const auto r1 = [&](int m, int n) {
    return rotation.m[kAxisOf[static_cast<std::size_t>(m + 1)]][kAxisOf[static_cast<std::size_t>(n + 1)]];
  };
  BandMatrix<double> below(1);
  for (int m = -1; m <= 1; ++m)
    for (int n = -1; n <= 1; ++n) below(m, n) = r1(m, n);
  for (int l = 2; l <= degree; ++l) {
    BandMatrix<double> band(l);
    const auto p = [&](int i, int a, int b) {
      if (b == l) return r1(i, 1) * below(a, l - 1) - r1(i, -1) * below(a, 1 - l);
      if (b == -l) return r1(i, 1) * below(a, 1 - l) + r1(i, -1) * below(a, l - 1);
      return r1(i, 0) * below(a, b);
    };
    for (int m = -l; m <= l; ++m)
      for (int n = -l; n <= l; ++n) {
        const int k = std::abs(m);
        const double d = std::abs(n) < l ? (l + n) * (l - n) : 2 * l * (2 * l - 1);
        double sum = 0;
        if (k < l) sum += std::sqrt((l + m) * (l - m) / d) * p(0, m, n);
        const double v = std::sqrt((m == 0 ? 2 : 1) * (l + k - 1) * (l + k) / d) / 2 * (m == 0 ? -1 : 1);
        if (m == 0) sum += v * (p(1, 1, n) + p(-1, -1, n));
        if (m > 0)
          sum += v * (p(1, m - 1, n) * (m == 1 ? std::sqrt(2.0) : 1) - (m == 1 ? 0 : p(-1, 1 - m, n)));
        if (m < 0)
          sum += v * ((m == -1 ? 0 : p(1, m + 1, n)) + p(-1, -m - 1, n) * (m == -1 ? std::sqrt(2.0) : 1));
        if (m != 0 && k < l - 1) {
          const double w = -std::sqrt((l - k - 1) * (l - k) / d) / 2;
          sum += w * (m > 0 ? p(1, m + 1, n) + p(-1, -m - 1, n) : p(1, m - 1, n) - p(-1, 1 - m, n));
        }
        band(m, n) = sum;
      }
    below = band;
  }
  return below.entries();
}

// The turn Ry(beta) alone, 0 < beta < pi, by the three-term recurrence in l carried out on the real matrix
// itself, as Lisle and Huang 2007 have it: entries (m, n) and (-m, -n) recur together, from d^l_ln at the
// rim.
inline std::vector<double> realRecurrenceTurnAboutY(int degree, double beta) {
  const double cosine = std::cos(beta), c = std::cos(beta / 2), s = std::sin(beta / 2);
  const auto rim = [&](int l, int n) {  // d^l_ln
    double logarithm = (l + n) * std::log(c) + (l - n) * std::log(s) +
                       (std::lgamma(2 * l + 1.0) - std::lgamma(l + n + 1.0) - std::lgamma(l - n + 1.0)) / 2;
    return ((l - n) % 2 ? -1 : 1) * std::exp(logarithm);
  };
  BandMatrix<double> band(0), below(0);
  band(0, 0) = 1;
  for (int l = 1; l <= degree; ++l) {
    BandMatrix<double> next(l);
    for (int m = 0; m <= l; ++m)
      for (int n = 0; n <= l; ++n) {
        if (m == l || n == l) {
          // d_ml = (-1)^(l-m) d_lm, d_m,-l = d_l,-m.
          const double dSame = m == l ? rim(l, n) : ((l - m) % 2 ? -1 : 1) * rim(l, m);
          const double dOpposite = m == l ? rim(l, -n) : rim(l, -m);
          const double same = ((m + n) % 2 ? -1 : 1) * dSame, opposite = (m % 2 ? -1 : 1) * dOpposite;
          next(m, n) = (same + opposite) * (m == 0 || n == 0 ? std::sqrt(0.5) : 1);
          if (m > 0 && n > 0) next(-m, -n) = same - opposite;
          continue;
        }
        const double rows = (l - m) * (l + m), columns = (l - n) * (l + n);
        const double k = l * (2 * l - 1) / std::sqrt(rows * columns);
        const double mixed = l > 1 ? m * n / (l * (l - 1.0)) : 0;
        const bool inner = m < l - 1 && n < l - 1;
        const double q =
            inner ? std::sqrt((rows - 2 * l + 1) * (columns - 2 * l + 1)) / ((l - 1.0) * (2 * l - 1)) : 0;
        const bool pair = m > 0 && n > 0;
        next(m, n) =
            k * (cosine * band(m, n) - (pair ? mixed * band(-m, -n) : 0) - (inner ? q * below(m, n) : 0));
        if (pair)
          next(-m, -n) = k * (cosine * band(-m, -n) - mixed * band(m, n) - (inner ? q * below(-m, -n) : 0));
      }
    below = band;
    band = next;
  }
  return band.entries();
}

}  // namespace shprt::test
