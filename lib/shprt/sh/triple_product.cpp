// The triple-product tensor. For each pair (i, j) the selection rules leave at most two orders and the bands
// from |l1 - l2| to l1 + l2 in steps of two; each entry is one short sum over the nodes of a Gauss rule,
// exact since the integrand is a polynomial. A recurrence for Wigner's 3j symbols would save that sum, but
// one symbol alone took longer than this at degree 8, and an entry needs two of them and the way from complex
// harmonics to real ones.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "shprt/sh/basis.h"
#include "shprt/sh/latitude_rule.h"
#include "shprt/sh/product.h"

namespace shprt {
namespace {

constexpr double kNegligible = 1e-14;  // to degree 26 no integral but zero is below 1e-13

// The integrals that the selection rules leave to one pair; a few of them vanish nevertheless.
std::size_t countCandidates(int l1, int m1, int l2, int m2, int degree) {
  const CoupledOrders coupled = coupledOrders(m1, m2);
  const int last = std::min(l1 + l2, degree);
  int candidates = 0;
  for (int c = 0; c < coupled.count; ++c) {
    const int order = std::abs(coupled.orders[c]);
    const int first = std::max(std::abs(l1 - l2), order + ((order + l1 + l2) & 1));
    candidates += std::max(0, (last - first + 2) / 2);
  }
  return static_cast<std::size_t>(candidates);
}

}  // namespace

TripleProductTensor::TripleProductTensor(int degreeF, int degreeG, int degreeProduct)
    : degreeF_(degreeF), degreeG_(degreeG), degreeProduct_(degreeProduct) {
  const auto forEachPair = [degreeF, degreeG](const auto& visit) {
    for (int l1 = 0; l1 <= degreeF; ++l1)
      for (int m1 = -l1; m1 <= l1; ++m1)
        for (int l2 = 0; l2 <= degreeG; ++l2)
          for (int m2 = -l2; m2 <= l2; ++m2) visit(l1, m1, l2, m2);
  };
  // Large tensors spend more time on growing than on their integrals.
  std::size_t candidates = 0;
  forEachPair(
      [&](int l1, int m1, int l2, int m2) { candidates += countCandidates(l1, m1, l2, m2, degreeProduct); });
  entries_.reserve(candidates);
  const LatitudeRule rule(std::max({degreeF, degreeG, degreeProduct}), degreeF + degreeG + degreeProduct);
  forEachPair([&](int l1, int m1, int l2, int m2) { addPair(rule, l1, m1, l2, m2); });
}

void TripleProductTensor::addPair(const LatitudeRule& rule, int l1, int m1, int l2, int m2) {
  const std::span<const double> weights = rule.weights(), first = rule.harmonic(l1, m1),
                                second = rule.harmonic(l2, m2);
  std::vector<double> pair(weights.size());
  for (std::size_t n = 0; n < pair.size(); ++n) pair[n] = weights[n] * first[n] * second[n];
  const CoupledOrders coupled = coupledOrders(m1, m2);
  for (int l3 = std::abs(l1 - l2); l3 <= std::min(l1 + l2, degreeProduct_); l3 += 2)
    for (int c = 0; c < coupled.count; ++c) {
      const int m3 = coupled.orders[c];
      if (std::abs(m3) > l3) continue;
      const std::span<const double> third = rule.harmonic(l3, m3);
      double sum = 0;
      for (std::size_t n = 0; n < pair.size(); ++n) sum += pair[n] * third[n];
      const double value = sum * longitudeIntegral(m1, m2, m3);
      if (std::fabs(value) >= kNegligible)
        entries_.push_back({shIndex(l1, m1), shIndex(l2, m2), shIndex(l3, m3), value});
    }
}

void TripleProductTensor::multiply(std::span<const double> f, std::span<const double> g,
                                   std::span<double> product) const {
  assert(f.size() == static_cast<std::size_t>(coefficientCount(degreeF_)));
  assert(g.size() == static_cast<std::size_t>(coefficientCount(degreeG_)));
  assert(product.size() == static_cast<std::size_t>(coefficientCount(degreeProduct_)));
  std::fill(product.begin(), product.end(), 0.0);
  for (const TripleProduct& t : entries_)
    product[static_cast<std::size_t>(t.k)] +=
        t.value * f[static_cast<std::size_t>(t.i)] * g[static_cast<std::size_t>(t.j)];
}

}  // namespace shprt
