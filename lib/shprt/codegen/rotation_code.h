// Code that turns RGB coefficients by a 3x3 matrix, without Euler angles, square roots or branches.
//
// Band 1 is a vector. Any other band l is the sum of 2l+1 delta functions whose directions w_j stand evenly
// around a cone about z: they are sum_j a_j y_l(w_j) with constant a = A^-1 c, and the turned band is sum_j
// a_j y_l(R w_j). On such a ring A is a discrete Fourier matrix whose orders m are scaled by g_m = |y_l|m||
// on the cone, so its inverse is explicit, and the condition is max g_m / min g_m: from 1.55 (band 2) to 2.43
// (band 8) for the cones chosen here. Lobes j and -j share their sums over m >= 0 and m < 0.
#pragma once

#include <string>

#include "shprt/codegen/dialect.h"

namespace shprt {

// The functions shAddBand2 .. shAddBandN and shRotate, for degree in [0, kMaximumCodeRotationDegree].
std::string rotationCode(const Dialect& dialect, int degree);

}  // namespace shprt
