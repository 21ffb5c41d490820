// The integral of T_a T_b T_c over longitude, by the product formulas of the cosine: with three cosines it
// is pi/2 for each of a+b=c, b+c=a, c+a=b, a+b+c=0 that holds; with two sines, whose orders are a and b, the
// terms a+b=c and a+b+c=0 change sign. One sine, or three, give zero.

#include "shprt/sh/latitude_rule.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "shprt/sh/basis.h"
#include "shprt/sh/gauss_legendre.h"

namespace shprt {
namespace {

int degreeOf(std::size_t coefficients) {
  return static_cast<int>(std::lround(std::sqrt(static_cast<double>(coefficients)))) - 1;
}

double twoSinesAndCosine(int a, int b, int c) {
  return (a == b + c) + (b == c + a) - (a + b == c) - (a + b + c == 0);
}

}  // namespace

double longitudeIntegral(int m1, int m2, int m3) {
  const int a = std::abs(m1), b = std::abs(m2), c = std::abs(m3);
  double terms = 0;
  switch ((m1 < 0) + 2 * (m2 < 0) + 4 * (m3 < 0)) {
    case 0:
      terms = (a + b == c) + (b + c == a) + (c + a == b) + (a + b + c == 0);
      break;
    case 1 + 2:
      terms = twoSinesAndCosine(a, b, c);
      break;
    case 2 + 4:
      terms = twoSinesAndCosine(b, c, a);
      break;
    case 4 + 1:
      terms = twoSinesAndCosine(c, a, b);
      break;
    default:
      break;
  }
  return terms * std::numbers::pi / 2;
}

CoupledOrders coupledOrders(int m1, int m2) {
  const int low = std::abs(std::abs(m1) - std::abs(m2)), high = std::abs(m1) + std::abs(m2);
  const bool sine = (m1 < 0) != (m2 < 0);
  if (sine) return low == 0 || low == high ? CoupledOrders{{-high}, 1} : CoupledOrders{{-high, -low}, 2};
  return low == high ? CoupledOrders{{high}, 1} : CoupledOrders{{low, high}, 2};
}

LatitudeRule::LatitudeRule(int degree, int integrandDegree) {
  assert(degree >= 0 && integrandDegree >= 0);
  const GaussLegendreRule rule = gaussLegendre(integrandDegree / 2 + 1);
  const std::size_t all = rule.nodes.size(), southern = all / 2, count = all - southern;
  const auto rows = static_cast<std::size_t>((degree + 1) * (degree + 2) / 2);
  harmonics_.resize(rows * count);
  std::vector<double> y(static_cast<std::size_t>(coefficientCount(degree)));
  for (std::size_t node = 0; node < count; ++node) {
    const double z = rule.nodes[southern + node];
    weights_.push_back((z > 0 ? 2 : 1) * rule.weights[southern + node]);
    evaluateSh(degree, {std::sqrt((1 - z) * (1 + z)), 0, z}, y);
    for (int l = 0; l <= degree; ++l)
      for (int m = 0; m <= l; ++m)
        harmonics_[static_cast<std::size_t>(l * (l + 1) / 2 + m) * count + node] =
            y[static_cast<std::size_t>(shIndex(l, m))];
  }
}

std::span<const double> LatitudeRule::harmonic(int l, int m) const {
  return std::span(harmonics_)
      .subspan(static_cast<std::size_t>(l * (l + 1) / 2 + std::abs(m)) * nodeCount(), nodeCount());
}

LatitudeSeries::LatitudeSeries(const LatitudeRule& rule, int maximumOrder)
    : nodes_(rule.nodeCount()),
      maximumOrder_(maximumOrder),
      values_(2 * static_cast<std::size_t>(2 * maximumOrder + 1) * nodes_, 0.0) {}

LatitudeSeries::LatitudeSeries(const LatitudeRule& rule, std::span<const double> coefficients)
    : LatitudeSeries(rule, degreeOf(coefficients.size())) {
  assert(coefficients.size() == static_cast<std::size_t>(coefficientCount(maximumOrder_)));
  for (int l = 0; l <= maximumOrder_; ++l)
    for (int m = -l; m <= l; ++m) {
      const std::span<double> series = at((l + m) & 1, m);
      const std::span<const double> harmonic = rule.harmonic(l, m);
      const double coefficient = coefficients[static_cast<std::size_t>(shIndex(l, m))];
      for (std::size_t node = 0; node < nodes_; ++node) series[node] += coefficient * harmonic[node];
    }
}

std::span<double> LatitudeSeries::at(int parity, int m) {
  return std::span(values_).subspan(
      static_cast<std::size_t>(parity * (2 * maximumOrder_ + 1) + m + maximumOrder_) * nodes_, nodes_);
}

std::span<const double> LatitudeSeries::at(int parity, int m) const {
  return std::span(values_).subspan(
      static_cast<std::size_t>(parity * (2 * maximumOrder_ + 1) + m + maximumOrder_) * nodes_, nodes_);
}

}  // namespace shprt
