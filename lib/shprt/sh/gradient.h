// Gradients of real spherical harmonics on the sphere.
#pragma once

#include <span>

#include "shprt/base/vec.h"

namespace shprt {

// Writes values[i] = y_i(direction), as evaluateSh does, and gradients[i] = the gradient of y_i on the unit
// sphere, per radian: a vector of three dimensions, tangent to the sphere, which is the gradient at u =
// direction of the extension y_i(u / |u|). All i < coefficientCount(degree); both spans have at least that
// many entries. direction as for evaluateSh; poles are ordinary points. Error of each component at most (l +
// 1) times that of evaluateSh in its band (the largest gradients are about l sqrt((2l+1)/4pi) long).
void evaluateShGradient(int degree, Vec3d direction, std::span<double> values, std::span<Vec3d> gradients);

}  // namespace shprt
