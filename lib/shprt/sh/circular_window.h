// The circular window: constant inside a cone about an axis, zero outside. A disc light far away, a cap.
#pragma once

#include <vector>

namespace shprt {

// Band factors (see zonal.h) of the window of the given angular radius in radians, 0 < radius <= pi,
// normalised to h_0 = 1: k(t) = 1 / solid angle where t >= cos(radius). Of any degree >= 0; a tiny window
// tends to the directional light, whose factors are all 1. A window of unit radiance has these factors times
// circularWindowSolidAngle(radius). Error at most 2e-15 cos^2(radius/2), the scale of the factors, whatever
// the radius (measured to degree 1000). Throws Error when radius is out of range.
std::vector<double> circularWindowFactors(int degree, double radius);

// 2 pi (1 - cos(radius)) in steradians, exact to rounding however small the radius is.
double circularWindowSolidAngle(double radius);

}  // namespace shprt
