// Products of functions given by spherical-harmonic coefficients.
//
// The product of two functions of degrees a and b has degree a + b; each function below gives its
// coefficients up to the degree asked for, and truncates nothing on the way. With G_ijk the integral of
// y_i y_j y_k over the sphere, (f g)_k = sum over i, j of G_ijk f_i g_j. G_ijk vanishes unless the bands
// fulfil the triangle inequality and add up to an even number, and the orders couple. Index and normalisation
// as in basis.h. All integrals are exact quadratures; an error is at most 1e-15 |f| |g|, with |.| the root of
// the sum of squares of coefficients (measured to degree 100).
#pragma once

#include <span>
#include <vector>

namespace shprt {

class LatitudeRule;

struct TripleProduct {
  int i, j, k;
  double value;  // G_ijk, to 1e-15 for degrees up to 8, 5e-15 up to 26
};

// The coupling of all pairs of functions of two degrees, for products that are taken often: 1158 entries for
// three degrees of 4, 23621 of 8, 601569 of 16, some O(degree^5). Building costs O(degree) per entry. From
// degree 8 on productCoefficients is as fast.
class TripleProductTensor {
 public:
  // All G_ijk with i, j, k in the bands up to degreeF, degreeG, degreeProduct.
  TripleProductTensor(int degreeF, int degreeG, int degreeProduct);

  // Ordered by i, then j, then k; every permutation that the degrees allow is listed. Values below 1e-14 in
  // magnitude, which are zeros of the integral or cannot be told from them, are left out.
  std::span<const TripleProduct> entries() const { return entries_; }

  // product = the coefficients of f g up to degreeProduct. Sizes are (degree+1)^2 of each; product may not
  // overlap f or g.
  void multiply(std::span<const double> f, std::span<const double> g, std::span<double> product) const;

 private:
  void addPair(const LatitudeRule& rule, int l1, int m1, int l2, int m2);

  int degreeF_, degreeG_, degreeProduct_;
  std::vector<TripleProduct> entries_;
};

// The coefficients of f g up to degree, from those of f and g, whose sizes are squares (degree+1)^2. Costs
// O(degree^3) and needs no tensor.
std::vector<double> productCoefficients(std::span<const double> f, std::span<const double> g, int degree);

// Multiplication by a fixed function, say a visibility, as a matrix: coefficientCount(degreeOut) rows of
// coefficientCount(degreeIn) entries, row-major. matrix * g = productCoefficients(f, g, degreeOut) for every
// g of degreeIn. Symmetric when the degrees are equal.
std::vector<double> productMatrix(std::span<const double> f, int degreeIn, int degreeOut);

}  // namespace shprt
