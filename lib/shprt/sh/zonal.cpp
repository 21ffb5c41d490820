// Band factors by two-term recurrences: each is a product of ratios, so errors add up and never cancel.
//   Phong: integral_0^1 t^s P_l dt = (s-l+2)/(s+l+1) integral_0^1 t^s P_{l-2} dt, from the integral of t^s
//   times Legendre's equation; s = 1 gives the clamped cosine.
//   Power lobe: integral_0^1 x^s P_l(2x-1) dx = Gamma(s+1)^2 / (Gamma(s-l+1) Gamma(s+l+2)), by Rodrigues'
//   formula and l partial integrations.
//   Henyey-Greenstein: Legendre's generating function.

#include "shprt/sh/zonal.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "shprt/base/error.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

std::vector<double> unitFactors(int degree) {
  assert(degree >= 0);
  return std::vector<double>(static_cast<std::size_t>(degree) + 1, 1.0);
}

void checkExponent(const char* lobe, double exponent) {
  if (!(exponent >= 0) || !std::isfinite(exponent))
    throw Error(lobe, "the exponent " + std::to_string(exponent) + " is out of range", "give 0 or more");
}

}  // namespace

std::vector<double> clampedCosineFactors(int degree) {
  using std::numbers::pi;
  std::vector<double> factors(static_cast<std::size_t>(degree) + 1, 0.0);
  factors[0] = pi;
  if (degree >= 1) factors[1] = 2 * pi / 3;
  double binomial = 1;  // l! / (2^l (l/2)!^2)
  for (int l = 2; l <= degree; l += 2) {
    binomial *= (l - 1.0) / l;
    const double sign = l % 4 == 2 ? 1 : -1;
    factors[static_cast<std::size_t>(l)] = sign * 2 * pi * binomial / ((l + 2.0) * (l - 1.0));
  }
  return factors;
}

std::vector<double> phongLobeFactors(int degree, double exponent) {
  checkExponent("phong lobe", exponent);
  std::vector<double> factors = unitFactors(degree);
  if (degree >= 1) factors[1] = (exponent + 1) / (exponent + 2);
  for (std::size_t l = 2; l < factors.size(); ++l) {
    const auto order = static_cast<double>(l);
    factors[l] = factors[l - 2] * ((exponent - (order - 2)) / (exponent + (order + 1)));
  }
  return factors;
}

std::vector<double> powerLobeFactors(int degree, double exponent) {
  checkExponent("power lobe", exponent);
  std::vector<double> factors = unitFactors(degree);
  for (std::size_t l = 1; l < factors.size(); ++l) {
    const auto order = static_cast<double>(l);
    factors[l] = factors[l - 1] * ((exponent - (order - 1)) / (exponent + (order + 1)));
  }
  return factors;
}

std::vector<double> henyeyGreensteinFactors(int degree, double g) {
  if (!(std::fabs(g) < 1))
    throw Error("henyey-greenstein", "g = " + std::to_string(g) + " is out of range",
                "give a number between -1 and 1");
  std::vector<double> factors = unitFactors(degree);
  for (std::size_t l = 1; l < factors.size(); ++l) factors[l] = factors[l - 1] * g;
  return factors;
}

void zonalCoefficients(Vec3d axis, std::span<const double> factors, std::span<double> coefficients) {
  assert(!factors.empty() && coefficients.size() == factors.size() * factors.size());
  evaluateSh(static_cast<int>(factors.size()) - 1, axis, coefficients);
  convolve(coefficients, factors);
}

void convolve(std::span<double> coefficients, std::span<const double> factors) {
  assert(coefficients.size() == factors.size() * factors.size());
  for (std::size_t l = 0; l < factors.size(); ++l)
    for (std::size_t i = l * l; i < (l + 1) * (l + 1); ++i) coefficients[i] *= factors[l];
}

double evaluateZonal(std::span<const double> factors, double cosTheta) {
  double previous = 0, legendre = 1, sum = 0;
  for (std::size_t l = 0; l < factors.size(); ++l) {
    const auto order = static_cast<double>(l);
    sum += (2 * order + 1) * factors[l] * legendre;
    const double next = ((2 * order + 1) * cosTheta * legendre - order * previous) / (order + 1);
    previous = legendre;
    legendre = next;
  }
  return sum / (4 * std::numbers::pi);
}

}  // namespace shprt
