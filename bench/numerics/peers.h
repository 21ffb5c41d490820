// The formulas of the papers as they are printed, to show where they end. Only compared with, never used.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "shprt/sh/basis.h"

namespace shprt::numerics {

// Recurrence on unnormalised associated Legendre functions, normalised at the end by factorials.
// Based on: Lisle and Huang, their evaluation (and most textbooks); without their Condon-Shortley sign.
template <typename Real>
std::vector<Real> unnormalisedBasis(int degree, Real x, Real y, Real z) {
  std::vector<Real> values(static_cast<std::size_t>(coefficientCount(degree)));
  Real sectoral = 1, re = 1, im = 0;
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) {
      sectoral *= static_cast<Real>(2 * m - 1);
      const Real next = re * x - im * y;
      im = re * y + im * x;
      re = next;
    }
    Real before = 0, here = sectoral;
    for (int l = m; l <= degree; ++l) {
      if (l > m) {
        const Real next = (static_cast<Real>(2 * l - 1) * z * here - static_cast<Real>(l + m - 1) * before) /
                          static_cast<Real>(l - m);
        before = here;
        here = next;
      }
      Real ratio = 1;  // (l - m)! / (l + m)!
      for (int k = l - m + 1; k <= l + m; ++k) ratio /= static_cast<Real>(k);
      const Real norm = std::sqrt(static_cast<Real>(2 * l + 1) / (4 * std::numbers::pi_v<Real>)*ratio *
                                  static_cast<Real>(m > 0 ? 2 : 1));
      values[static_cast<std::size_t>(shIndex(l, m))] = norm * here * re;
      if (m > 0) values[static_cast<std::size_t>(shIndex(l, -m))] = norm * here * im;
    }
  }
  return values;
}

// Normalised recurrences that take z as it is stored: right in range, and losing l^2/2 roundings of z at the
// poles. Based on: Holmes and Featherstone 2002, eqs. 11-12. In double holds to degree 1478.
template <typename Real>
std::vector<Real> storedHeightBasis(int degree, Real x, Real y, Real z) {
  std::vector<Real> values(static_cast<std::size_t>(coefficientCount(degree)));
  Real sectoral = std::sqrt(1 / (4 * std::numbers::pi_v<Real>)), re = 1, im = 0;
  for (int m = 0; m <= degree; ++m) {
    const auto realM = static_cast<Real>(m);
    if (m > 0) {
      sectoral *= std::sqrt((m == 1 ? Real{2} : Real{1}) * (2 * realM + 1) / (2 * realM));
      const Real next = re * x - im * y;
      im = re * y + im * x;
      re = next;
    }
    Real before = 0, here = sectoral;
    for (int l = m; l <= degree; ++l) {
      if (l > m) {
        const auto realL = static_cast<Real>(l), lower = realL - 1;
        const Real a = std::sqrt((4 * realL * realL - 1) / (realL * realL - realM * realM));
        const Real b = std::sqrt((lower * lower - realM * realM) / (4 * lower * lower - 1));
        const Real next = a * (z * here - b * before);
        before = here;
        here = next;
      }
      values[static_cast<std::size_t>(shIndex(l, m))] = here * re;
      if (m > 0) values[static_cast<std::size_t>(shIndex(l, -m))] = here * im;
    }
  }
  return values;
}

// (l + 2) f_{l+1} = (2l + 1) z f_l - (l - 1) f_{l-1} with z = cos(zeta).
// Based on: Lisle and Huang, eq. 11.
template <typename Real>
std::vector<Real> printedWindow(int degree, Real zeta) {
  const Real z = std::cos(zeta);
  std::vector<Real> factors{1, (1 + z) / 2};
  for (int l = 1; l < degree; ++l) {
    const auto n = static_cast<std::size_t>(l);
    factors.push_back(
        (static_cast<Real>(2 * l + 1) * z * factors[n] - static_cast<Real>(l - 1) * factors[n - 1]) /
        static_cast<Real>(l + 2));
  }
  return factors;
}

}  // namespace shprt::numerics
