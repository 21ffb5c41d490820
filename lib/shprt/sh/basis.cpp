// Real spherical harmonics, one direction, in double: the difference form of recurrence.h, times powers of
// x + iy. No factorials appear, nothing is divided by sin(theta), and poles are ordinary points. Powers and
// polynomials that leave the exponent range on the way to values that do not are rescaled by powers of two,
// which is exact.

#include "shprt/sh/basis.h"

#include <algorithm>
#include <cmath>

#include "shprt/sh/recurrence.h"

namespace shprt {
namespace {

constexpr double kSmall = 0x1p-100, kLarge = 0x1p100;
constexpr int kScaleExponent = 100;
constexpr int kLeastExponent = -500;  // what is scaled by less is written as zero
constexpr double kNegligible = 0x1p-300;

// |u|^2 - 1, to twice the precision of its terms.
double squaredExcess(Vec3d u) {
  double sum = -1, rest = 0;
  for (const double component : {u.x, u.y, u.z}) {
    const double square = component * component;
    rest += std::fma(component, component, -square);
    const double next = sum + square, added = next - sum;
    rest += (sum - (next - added)) + (square - added);
    sum = next;
  }
  return sum + rest;
}

// What the recurrences need of a direction u.
struct PolarDirection {
  double x, y;    // of u, of unit length but for `excess`
  double excess;  // its length - 1, at most a few roundings
  double t;       // 1 - |z| of u / |u|
  bool south;
};

PolarDirection polarDirection(Vec3d u) {
  // What is off by more than rounding is first brought to unit length; what is left to correct is then
  // linear.
  if (std::fabs(squaredExcess(u)) > 0x1p-50) u = normalize(u);
  const double excess = squaredExcess(u) / 2, height = std::fabs(u.z);
  // Near a pole x and y hold the angle better than z does; beside the equator z does.
  const double t = height < 0.5 ? (1 - height) + height * excess : (u.x * u.x + u.y * u.y) / (1 + height);
  const auto visible = [](double a) { return std::fabs(a) < kNegligible ? 0 : a; };
  return {visible(u.x), visible(u.y), excess, t, std::signbit(u.z)};
}

// N_mm (x + iy)^m as (re, im) 2^exponent. The larger part stays above kSmall, unless both are zero.
struct ScaledPower {
  double re = kY00, im = 0;
  int exponent = 0;

  void multiply(double x, double y, double factor) {
    const double next = (re * x - im * y) * factor;
    im = (re * y + im * x) * factor;
    re = next;
    while (std::fabs(re) < kSmall && std::fabs(im) < kSmall && !isZero()) {
      re *= kLarge;
      im *= kLarge;
      exponent -= kScaleExponent;
    }
  }
  bool isZero() const { return re == 0 && im == 0; }
};

double powerOfTwo(int exponent) {
  return exponent < kLeastExponent ? 0 : std::ldexp(1.0, exponent);
}

// All bands of one order: y_{l,m} and y_{l,-m} for l from m to degree.
void evaluateOrder(int degree, int m, const PolarDirection& u, const ScaledPower& power, double* results) {
  if (power.isZero()) {
    for (int l = m; l <= degree; ++l) results[shIndex(l, m)] = results[shIndex(l, -m)] = 0;
    return;
  }
  const RecurrenceTable& table = recurrenceTable();
  const DifferenceStep* steps = m < table.degree ? table.order(m) : nullptr;
  const double length = 1 - m * u.excess, re = power.re * length, im = power.im * length;
  double g = 1, d = 0, norm = 1, sign = 1, scale = powerOfTwo(power.exponent);
  int exponent = power.exponent;
  for (int l = m;;) {
    const double value = g * norm * (sign * scale);
    double* centre = results + static_cast<std::ptrdiff_t>(l) * (l + 1);
    centre[m] = value * re;
    if (m > 0) centre[-m] = value * im;
    if (++l > degree) break;
    const DifferenceStep step = l <= table.degree ? steps[l - m - 1] : differenceStep(l, m);
    const double fall = u.t * g;
    d = step.alpha * (d - fall) - fall;
    g += d;
    norm *= step.growth;
    if (u.south) sign = -sign;
    if (norm > kLarge) {
      norm *= kSmall;
      if (exponent < 0) {
        exponent += kScaleExponent;
        scale = powerOfTwo(exponent);
      } else {
        g *= kLarge;
        d *= kLarge;
      }
    }
  }
}

}  // namespace

void evaluateSh(int degree, Vec3d direction, std::span<double> results) {
  assert(degree >= 0 && results.size() >= static_cast<std::size_t>(coefficientCount(degree)));
  const PolarDirection u = polarDirection(direction);
  const RecurrenceTable& table = recurrenceTable();
  ScaledPower power;
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) {
      const double factor =
          m <= table.degree ? table.sectoral[static_cast<std::size_t>(m)] : sectoralFactor(m);
      power.multiply(u.x, u.y, factor);
    }
    evaluateOrder(degree, m, u, power, results.data());
  }
}

}  // namespace shprt
