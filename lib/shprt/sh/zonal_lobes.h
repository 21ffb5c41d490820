// Spherical harmonics as weighted sums of zonal lobes along fixed directions: such a sum is rotated by
// rotating its directions, without any rotation matrix of a band.
//
// The lobe of band l about the unit direction d is u -> sqrt((2l+1)/(4 pi)) P_l(u . d), which is y_l0 turned
// to d, of norm 1, with the coefficients sqrt(4 pi/(2l+1)) y_lm(d) in band l. Band l is the sum of 2l+1 lobes
// along the first 2l+1 of the shared directions; its weights solve A_l w = c_l, where the columns of A_l are
// the coefficients of the lobes. Index of weights: lobe d of band l at l*l + d, 0 <= d <= 2l, so weights are
// as many as coefficients.
// Based on: Nowrouzezahrai, Simari and Fiume 2012 (the factorisation and the sharing of directions; the
// directions are this project's own).
#pragma once

#include <span>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

inline constexpr int kMaximumLobeDegree = 16;

// The 2 degree + 1 unit directions for functions up to degree, 0 <= degree <= kMaximumLobeDegree. Fixed
// constants: the beginning of one of four sequences, made for the bands to 2, 4, 8 and 16, so that weights
// are exchanged between programs if they agree on the degree.
std::vector<Vec3d> lobeDirections(int degree);

// The factorisation for one degree; building inverts one matrix per band, O(degree^4).
class ZonalLobes {
 public:
  // Throws Error when degree is not in [0, kMaximumLobeDegree].
  explicit ZonalLobes(int degree);

  int degree() const { return degree_; }
  std::span<const Vec3d> directions() const { return directions_; }

  // weights = A^-1 coefficients, band by band; both have (degree+1)^2 entries and may not overlap. Errors are
  // those of rounding times the condition number of A_l.
  void weights(std::span<const double> coefficients, std::span<double> weights) const;

  // Rotates coefficients in place by (R f)(u) = f(R^-1 u), as ShRotation does, by way of the lobes. rotation
  // is orthonormal.
  void rotate(const Mat3& rotation, std::span<double> coefficients) const;

 private:
  int degree_;
  std::vector<Vec3d> directions_;
  std::vector<double> inverses_;  // A_l^-1 for l = 0, 1, ..., each row-major
};

// coefficients = the sum of the lobes with these weights along these directions, 2 degree + 1 of any unit
// vectors: the fixed ones, or those after a rotation. weights and coefficients have (degree+1)^2 entries and
// may not overlap.
void lobeCoefficients(std::span<const Vec3d> directions, std::span<const double> weights,
                      std::span<double> coefficients);

// The value at the unit vector u of the sum of lobes.
double evaluateLobes(std::span<const Vec3d> directions, std::span<const double> weights, Vec3d u);

}  // namespace shprt
