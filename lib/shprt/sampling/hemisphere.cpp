#include "shprt/sampling/hemisphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shprt {

Vec3d sampleCosineHemisphere(double u, double v) {
  const double radius = std::sqrt(u);
  const double phi = 2 * std::numbers::pi * v;
  return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(1 - u)};
}

Vec3f cosineDirectionAround(const Frame& frame, double u, double v) {
  return toFloat(frame.toWorld(sampleCosineHemisphere(std::min(u, static_cast<double>(kLargestRing)), v)));
}

double pdfCosineHemisphere(Vec3d direction) {
  return direction.z > 0 ? direction.z / std::numbers::pi : 0;
}

}  // namespace shprt
