// The recurrence that evaluates spherical harmonics, in a form in which nothing cancels beside the poles.
//
// Let G_lm be the Gegenbauer polynomial C_{l-m} of parameter m + 1/2, scaled to 1 at z = 1; t = 1 - |z|; and
// D_l = G_l - G_{l-1}. The three-term recurrence of G at |z| is
//   D_l = alpha_l (D_{l-1} - t G_{l-1}) - t G_{l-1},    G_l = G_{l-1} + D_l,    alpha_l = (l-1-m) / (l+m),
// from G_m = 1, D_m = 0. The small t enters as itself, where the usual form rounds 1 - t and has l^2/2 times
// the error of that. Then y_lm = N_lm G_lm Re or Im (x + iy)^m, below the equator times (-1)^(l+m), where
// N_lm = sqrt((2l+1)/4pi (l+m)!/(l-m)!) / (2^m m!), times sqrt(2) for m > 0, is the normalised Legendre
// function over sin^m at the pole. Based on: the recurrence (n+1) C_{n+1} = 2 (n+a) z C_n - (n+2a-1) C_{n-1}
// of Gegenbauer polynomials and C_n(1) = (2a)_n / n!, with a = m + 1/2.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace shprt {

inline constexpr double kY00 = 0.28209479177387814347;  // 1 / sqrt(4 pi)

struct DifferenceStep {
  double alpha;   // (l-1-m) / (l+m)
  double growth;  // N_lm / N_{l-1,m}
};

// The step to band l, for l > m >= 0.
inline DifferenceStep differenceStep(int l, int m) {
  const double odd = 2.0 * l - 1, sum = static_cast<double>(l) + m, difference = static_cast<double>(l) - m;
  return {(difference - 1) / sum, std::sqrt((odd + 2) * sum / (odd * difference))};
}

// N_mm / N_{m-1,m-1}, for m >= 1. The first carries the sqrt(2) of real harmonics.
inline double sectoralFactor(int m) {
  return std::sqrt((m == 1 ? 2.0 : 1.0) * (2.0 * m + 1) / (2.0 * m));
}

// The constants to a degree that covers stored coefficients; beyond, they are computed as they are needed.
struct RecurrenceTable {
  int degree;
  std::vector<double> sectoral;       // by m; the first is N_00
  std::vector<DifferenceStep> steps;  // for each m, for each l > m

  // The steps of order m, from l = m + 1 on.
  const DifferenceStep* order(int m) const {
    return steps.data() + static_cast<std::ptrdiff_t>(m * degree - m * (m - 1) / 2);
  }
};
const RecurrenceTable& recurrenceTable();

}  // namespace shprt
