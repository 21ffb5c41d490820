// A single product and the product matrix, without the tensor: on each latitude the factors are trigonometric
// series, which multiply in closed form, and a Gauss rule integrates over the latitudes.

#include "shprt/sh/product.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "shprt/sh/basis.h"
#include "shprt/sh/latitude_rule.h"

namespace shprt {
namespace {

int degreeOf(std::span<const double> coefficients) {
  const auto root = static_cast<int>(std::lround(std::sqrt(static_cast<double>(coefficients.size()))));
  assert(root >= 1 && coefficients.size() == static_cast<std::size_t>(root) * static_cast<std::size_t>(root));
  return root - 1;
}

// The integral over longitude of f g T_m, latitude by latitude.
LatitudeSeries multiplySeries(const LatitudeRule& rule, const LatitudeSeries& f, const LatitudeSeries& g,
                              int maximumOrder) {
  LatitudeSeries product(rule, maximumOrder);
  for (int m1 = -f.maximumOrder(); m1 <= f.maximumOrder(); ++m1)
    for (int m2 = -g.maximumOrder(); m2 <= g.maximumOrder(); ++m2) {
      const CoupledOrders coupled = coupledOrders(m1, m2);
      for (int c = 0; c < coupled.count; ++c) {
        const int m3 = coupled.orders[c];
        if (std::abs(m3) > maximumOrder) continue;
        const double coupling = longitudeIntegral(m1, m2, m3);
        for (const int parityF : {0, 1})
          for (const int parityG : {0, 1}) {
            const std::span<const double> left = f.at(parityF, m1), right = g.at(parityG, m2);
            const std::span<double> sum = product.at(parityF ^ parityG, m3);
            for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += coupling * left[n] * right[n];
          }
      }
    }
  return product;
}

}  // namespace

std::vector<double> productCoefficients(std::span<const double> f, std::span<const double> g, int degree) {
  assert(degree >= 0);
  const int degreeF = degreeOf(f), degreeG = degreeOf(g);
  const LatitudeRule rule(std::max({degreeF, degreeG, degree}), degreeF + degreeG + degree);
  const LatitudeSeries product =
      multiplySeries(rule, LatitudeSeries(rule, f), LatitudeSeries(rule, g), degree);
  std::vector<double> coefficients(static_cast<std::size_t>(coefficientCount(degree)));
  const std::span<const double> weights = rule.weights();
  for (int l = 0; l <= degree; ++l)
    for (int m = -l; m <= l; ++m) {
      const std::span<const double> series = product.at((l + m) & 1, m), harmonic = rule.harmonic(l, m);
      double sum = 0;
      for (std::size_t n = 0; n < weights.size(); ++n) sum += weights[n] * series[n] * harmonic[n];
      coefficients[static_cast<std::size_t>(shIndex(l, m))] = sum;
    }
  return coefficients;
}

std::vector<double> productMatrix(std::span<const double> f, int degreeIn, int degreeOut) {
  assert(degreeIn >= 0 && degreeOut >= 0);
  const int degreeF = degreeOf(f);
  const LatitudeRule rule(std::max({degreeF, degreeIn, degreeOut}), degreeF + degreeIn + degreeOut);
  const LatitudeSeries factor(rule, f);
  const std::span<const double> weights = rule.weights();
  std::vector<double> matrix, weighted(rule.nodeCount());
  matrix.reserve(static_cast<std::size_t>(coefficientCount(degreeOut)) *
                 static_cast<std::size_t>(coefficientCount(degreeIn)));
  for (int l3 = 0; l3 <= degreeOut; ++l3)
    for (int m3 = -l3; m3 <= l3; ++m3) {
      const std::span<const double> rowHarmonic = rule.harmonic(l3, m3);
      for (std::size_t n = 0; n < weighted.size(); ++n) weighted[n] = weights[n] * rowHarmonic[n];
      for (int l2 = 0; l2 <= degreeIn; ++l2)
        for (int m2 = -l2; m2 <= l2; ++m2) {
          const std::span<const double> columnHarmonic = rule.harmonic(l2, m2);
          const CoupledOrders coupled = coupledOrders(m2, m3);
          double entry = 0;
          for (int c = 0; c < coupled.count; ++c) {
            const int m1 = coupled.orders[c];
            if (std::abs(m1) > degreeF) continue;
            const std::span<const double> series = factor.at((l2 + m2 + l3 + m3) & 1, m1);
            double sum = 0;
            for (std::size_t n = 0; n < weighted.size(); ++n)
              sum += weighted[n] * columnHarmonic[n] * series[n];
            entry += sum * longitudeIntegral(m1, m2, m3);
          }
          matrix.push_back(entry);
        }
    }
  return matrix;
}

}  // namespace shprt
