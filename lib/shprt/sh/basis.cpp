// Real spherical harmonics by recurrences on normalised polynomials.
//
// y_lm = Pi_lm(z) Re or Im (x + iy)^m, where Pi_lm is the associated Legendre function without its factor
// sin^m, carrying the whole normalisation. So no factorials appear, nothing is divided by sin(theta), and
// poles are ordinary points. Based on: Holmes and Featherstone 2002, eqs. 11-12 (normalised recurrences) and
// section 2.7 (splitting off sin^m). Where a power or a polynomial nears the ends of the exponent range both
// are rescaled by powers of two, which is exact.

#include "shprt/sh/basis.h"

#include <cmath>

#include "shprt/sh/recurrence.h"

namespace shprt {
namespace {

constexpr double kSmall = 0x1p-400, kLarge = 0x1p400;
constexpr int kScaleExponent = 400;

// A number times 2^exponent, for sequences that leave the range of double on the way to values that do not.
struct Power {
  double re = 1, im = 0;  // (x + iy)^m
  int exponent = 0;

  void multiply(double x, double y) {
    const double next = re * x - im * y;
    im = re * y + im * x;
    re = next;
    if (std::fabs(re) < kSmall && std::fabs(im) < kSmall) {
      re *= kLarge;
      im *= kLarge;
      exponent -= kScaleExponent;
    }
  }
};

double scaled(double value, int exponent) {
  return exponent == 0 ? value : std::ldexp(value, exponent);
}

}  // namespace

PolarHeight polarHeight(Vec3d direction) {
  const double squared = direction.x * direction.x + direction.y * direction.y;
  if (squared >= 0.5) return {direction.z, 0};
  // Near a pole the rounding of z is amplified by l^2/2; x and y hold the angle far better there. 1 - |z| is
  // small and known to full precision, so z is carried as its rounded value and what the rounding lost.
  const double drop = squared / (1 + std::sqrt(1 - squared));
  const double height = 1 - drop;
  const double lost = (1 - height) - drop;
  return {std::copysign(height, direction.z), std::copysign(1.0, direction.z) * lost};
}

void evaluateSh(int degree, Vec3d direction, std::span<double> results) {
  assert(degree >= 0 && results.size() >= static_cast<std::size_t>(coefficientCount(degree)));
  const PolarHeight z = polarHeight(direction);
  const RecurrenceTable& table = recurrenceTable();
  Power power;
  double sectoral = kY00;  // Pi_mm
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) {
      power.multiply(direction.x, direction.y);
      sectoral *= sectoralFactor(m);
    }
    double previous = 0, current = sectoral;
    int exponent = power.exponent;
    for (int l = m; l <= degree; ++l) {
      if (l > m) {
        const Recurrence r = l <= table.degree ? table.at(l, m) : recurrence(l, m);
        const double next = r.a * (z.value * current - r.b * previous + z.rest * current);
        previous = current;
        current = next;
        if (std::fabs(current) > kLarge) {
          current *= kSmall;
          previous *= kSmall;
          exponent += kScaleExponent;
        }
      }
      results[static_cast<std::size_t>(shIndex(l, m))] = scaled(current * power.re, exponent);
      if (m > 0) results[static_cast<std::size_t>(shIndex(l, -m))] = scaled(current * power.im, exponent);
    }
  }
}

}  // namespace shprt
