// The first moments of a function over directions: the lighting basis normalised by 4 pi, in which bands 0 to
// 2 are its average, a vector and a matrix.
#pragma once

#include <span>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

// Of a function L of directions w: averages over the sphere of L, L w and L (w w^T - I/3).
struct Moments {
  double mean = 0;
  Vec3d vector;                                    // |vector| / mean lies in [0,1] for non-negative L
  Mat3 matrix{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};  // symmetric, without trace
};

// Of the function with these coefficients of sh/basis.h; 1, 4 or 9 of them (degree 0, 1, 2; missing bands are
// zero).
Moments momentsOf(std::span<const double> coefficients);

// The coefficients of bands 0 to degree, degree at most 2. A trace the matrix should not have is taken out.
std::vector<double> coefficientsOf(const Moments& moments, int degree);

// Bands 0 to 2 of the function at a unit direction: mean + 3 vector.w + 15/2 w^T matrix w.
double evaluateMoments(const Moments& moments, Vec3d direction);

// Moments of the function that has at Q w the value this one has at w. Q is orthogonal; a reflection is fine.
Moments transformMoments(const Moments& moments, const Mat3& q);

}  // namespace shprt
