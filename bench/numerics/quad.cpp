#include "bench/numerics/quad.h"

#include <quadmath.h>

#include <cstddef>

#include "shprt/sh/basis.h"

namespace shprt::numerics {

Quad quadPi() {
  static const Quad pi = acosq(-1);  // the literal would need an extension of the language
  return pi;
}
Quad quadSqrt(Quad x) {
  return sqrtq(x);
}
Quad quadSin(Quad x) {
  return sinq(x);
}
Quad quadCos(Quad x) {
  return cosq(x);
}

std::vector<Quad> referenceBasis(int degree, Vec3d direction) {
  return referenceBasis(degree, direction, {}, 0);
}

std::vector<Quad> referenceBasis(int degree, Vec3d direction, Vec3d offset, Quad step) {
  Quad x = direction.x + step * offset.x, y = direction.y + step * offset.y,
       z = direction.z + step * offset.z;
  const Quad length = sqrtq(x * x + y * y + z * z);
  x /= length, y /= length, z /= length;
  std::vector<Quad> values(static_cast<std::size_t>(coefficientCount(degree)));
  Quad sectoral = 1 / sqrtq(4 * quadPi()), re = 1, im = 0;
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) {
      sectoral *= sqrtq((m == 1 ? Quad{2} : Quad{1}) * (2 * m + 1) / (2 * m));
      const Quad next = re * x - im * y;
      im = re * y + im * x;
      re = next;
    }
    Quad before = 0, here = sectoral;
    for (int l = m; l <= degree; ++l) {
      if (l > m) {
        const Quad square = static_cast<Quad>(m) * m, lower = l - 1;
        const Quad a = sqrtq((4 * static_cast<Quad>(l) * l - 1) / (static_cast<Quad>(l) * l - square));
        const Quad b = sqrtq((lower * lower - square) / (4 * lower * lower - 1));
        const Quad next = a * (z * here - b * before);
        before = here;
        here = next;
      }
      values[static_cast<std::size_t>(shIndex(l, m))] = here * re;
      if (m > 0) values[static_cast<std::size_t>(shIndex(l, -m))] = here * im;
    }
  }
  return values;
}

ReferenceWigner::ReferenceWigner(Quad beta) : cosine_(cosq(beta / 2)), sine_(sinq(beta / 2)), entries_{1} {}

void ReferenceWigner::climb() {
  halfStep();
  halfStep();
  ++band_;
}

Quad ReferenceWigner::at(int m, int n) const {
  return entries_[static_cast<std::size_t>((m + band_) * (2 * band_ + 1) + n + band_)];
}

// Risbo 1996: every factor is at most one, so nothing is amplified.
void ReferenceWigner::halfStep() {
  const int n = ++twiceJ_;
  std::vector<Quad> next(static_cast<std::size_t>((n + 1) * (n + 1))), root(static_cast<std::size_t>(n) + 1);
  for (int i = 0; i <= n; ++i) root[static_cast<std::size_t>(i)] = sqrtq(static_cast<Quad>(i));
  const auto rootOf = [&](int i) { return root[static_cast<std::size_t>(i)]; };
  const auto slot = [&](int i, int k) -> Quad& { return next[static_cast<std::size_t>(i * (n + 1) + k)]; };
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const Quad d = entries_[static_cast<std::size_t>(i * n + k)] / n;
      slot(i, k) += rootOf(n - i) * rootOf(n - k) * cosine_ * d;
      slot(i + 1, k) -= rootOf(i + 1) * rootOf(n - k) * sine_ * d;
      slot(i, k + 1) += rootOf(n - i) * rootOf(k + 1) * sine_ * d;
      slot(i + 1, k + 1) += rootOf(i + 1) * rootOf(k + 1) * cosine_ * d;
    }
  entries_ = std::move(next);
}

std::vector<Quad> referenceRotation(const ReferenceWigner& wigner, Quad alpha, Quad gamma) {
  const int l = wigner.band(), size = 2 * l + 1;
  std::vector<Quad> turn(static_cast<std::size_t>(size * size)), result(turn.size());
  const auto slot = [&](std::vector<Quad>& matrix, int m, int n) -> Quad& {
    return matrix[static_cast<std::size_t>((m + l) * size + n + l)];
  };
  for (int m = 0; m <= l; ++m)
    for (int n = 0; n <= l; ++n) {
      const Quad same = ((m + n) % 2 ? -1 : 1) * wigner.at(m, n),
                 opposite = (m % 2 ? -1 : 1) * wigner.at(m, -n);
      const Quad norm = m == 0 && n == 0 ? Quad{1} / 2 : m == 0 || n == 0 ? 1 / sqrtq(Quad{2}) : Quad{1};
      slot(turn, m, n) = norm * (same + opposite);
      if (m > 0 && n > 0) slot(turn, -m, -n) = same - opposite;
    }
  // Turns about z mix m and -m: first the columns by gamma, then the rows by alpha.
  std::vector<Quad> columns(turn.size());
  for (int m = -l; m <= l; ++m)
    for (int n = 0; n <= l; ++n) {
      const Quad c = cosq(n * gamma), s = sinq(n * gamma);
      const Quad plus = slot(turn, m, n), minus = n > 0 ? slot(turn, m, -n) : 0;
      slot(columns, m, n) = plus * c + minus * s;
      if (n > 0) slot(columns, m, -n) = minus * c - plus * s;
    }
  for (int m = 0; m <= l; ++m)
    for (int n = -l; n <= l; ++n) {
      const Quad c = cosq(m * alpha), s = sinq(m * alpha);
      const Quad plus = slot(columns, m, n), minus = m > 0 ? slot(columns, -m, n) : 0;
      slot(result, m, n) = c * plus - s * minus;
      if (m > 0) slot(result, -m, n) = s * plus + c * minus;
    }
  return result;
}

ReferenceAngles referenceAngles(const Mat3& matrix) {
  Quad r[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r[i][j] = matrix.m[i][j];
  // Newton's iteration for the orthonormal polar factor: the mean with the inverse transpose.
  for (int step = 0; step < 6; ++step) {
    Quad cofactor[3][3];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        cofactor[i][j] = r[i1][j1] * r[i2][j2] - r[i1][j2] * r[i2][j1];
      }
    const Quad determinant = r[0][0] * cofactor[0][0] + r[0][1] * cofactor[0][1] + r[0][2] * cofactor[0][2];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) r[i][j] = (r[i][j] + cofactor[i][j] / determinant) / 2;
  }
  const Quad alpha = atan2q(r[1][2], r[0][2]), s = sinq(alpha), c = cosq(alpha);
  return {alpha, atan2q(hypotq(r[0][2], r[1][2]), r[2][2]),
          atan2q(c * r[1][0] - s * r[0][0], c * r[1][1] - s * r[0][1])};
}

std::vector<Quad> referenceWindow(int degree, Quad zeta) {
  // The integral of P_l from z to 1 is (P_{l-1}(z) - P_{l+1}(z)) / (2l + 1); in 34 digits the cancellation at
  // 1e-8 rad leaves 17 of them.
  const Quad half = sinq(zeta / 2), drop = 2 * half * half;
  std::vector<Quad> legendre(static_cast<std::size_t>(degree) + 2), factors{1};
  // Differences P_l - P_{l-1} keep what P_l itself rounds away beside 1.
  Quad difference = 0, value = 1;
  legendre[0] = 1;
  std::vector<Quad> differences(legendre.size());
  for (int l = 0; l <= degree; ++l) {
    difference = (l * difference - (2 * l + 1) * drop * value) / (l + 1);
    value += difference;
    differences[static_cast<std::size_t>(l) + 1] = difference;
    legendre[static_cast<std::size_t>(l) + 1] = value;
  }
  for (int l = 1; l <= degree; ++l) {
    const Quad sum = differences[static_cast<std::size_t>(l)] + differences[static_cast<std::size_t>(l) + 1];
    factors.push_back(-sum / ((2 * l + 1) * drop));
  }
  return factors;
}

}  // namespace shprt::numerics
