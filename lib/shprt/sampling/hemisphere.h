// Warps of the unit square to the hemisphere around +z, with their densities.
#pragma once

#include "shprt/base/frame.h"
#include "shprt/base/vec.h"

namespace shprt {

// Maps (u, v) in [0,1)^2 to a direction with density cos(theta)/pi: u is the squared distance from the axis
// of its projection to the disc, v the azimuth in turns.
Vec3d sampleCosineHemisphere(double u, double v);

// The largest u below 1 in float. Rounding may push the outermost directions to the horizon or past it; sets
// of directions end here, 0.014 degrees above.
inline constexpr float kLargestRing = 0.99999994f;

// The same around frame.normal, unit to float and above the horizon for any u in [0,1].
Vec3f cosineDirectionAround(const Frame& frame, double u, double v);

// Density of sampleCosineHemisphere with respect to solid angle, for a unit direction; 0 below the horizon.
double pdfCosineHemisphere(Vec3d direction);

}  // namespace shprt
