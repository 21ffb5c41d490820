// Exact integrals over the sphere of products of three spherical harmonics, split into longitude, where they
// are known in closed form, and latitude, where a Gauss rule integrates polynomials exactly. What products
// and triple products share; not a public interface.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace shprt {

// The integral over phi of T_m1 T_m2 T_m3, where T_m = cos(m phi) for m >= 0 and sin(|m| phi) for m < 0.
double longitudeIntegral(int m1, int m2, int m3);

// The orders m3 for which longitudeIntegral(m1, m2, m3) does not vanish: one or two, ascending.
struct CoupledOrders {
  int orders[2];
  int count;
};
CoupledOrders coupledOrders(int m1, int m2);

// Nodes in z that integrate polynomials up to a degree, on the northern half only: integrands here are even
// in z, since triples of odd total degree vanish. Holds the latitude part of every y_lm there.
class LatitudeRule {
 public:
  // For tables of y_lm to degree, and integrands of polynomial degree at most integrandDegree in z.
  LatitudeRule(int degree, int integrandDegree);

  std::size_t nodeCount() const { return weights_.size(); }
  // Weights that integrate an even function over z in [-1, 1].
  std::span<const double> weights() const { return weights_; }
  // y_lm at the nodes without its factor cos(m phi) or sin(|m| phi).
  std::span<const double> harmonic(int l, int m) const;

 private:
  std::vector<double> weights_;
  std::vector<double> harmonics_;  // by l (l+1) / 2 + |m|, then node
};

// A function of the sphere on the nodes of a rule: for each order m the coefficient of T_m, its part even
// in z (parity 0) and its part odd in z (parity 1).
class LatitudeSeries {
 public:
  LatitudeSeries(const LatitudeRule& rule, int maximumOrder);
  // The function with these coefficients; maximumOrder is its degree.
  LatitudeSeries(const LatitudeRule& rule, std::span<const double> coefficients);

  int maximumOrder() const { return maximumOrder_; }
  std::span<double> at(int parity, int m);
  std::span<const double> at(int parity, int m) const;

 private:
  std::size_t nodes_;
  int maximumOrder_;
  std::vector<double> values_;
};

}  // namespace shprt
