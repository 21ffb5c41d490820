// Sums over pixels, and which pixels enter them.

#include "shprt/light/probe_sums.h"

#include <algorithm>

namespace shprt {

void ProbeSums::add(const ProbeSums& part) {
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) coefficients[i][c] += part.coefficients[i][c];
  pixels += part.pixels;
  nonFinite += part.nonFinite;
  negative += part.negative;
  solidAngle += part.solidAngle;
  weight += part.weight;
  for (std::size_t c = 0; c < 3; ++c) energy[c] += part.energy[c];
}

bool mendPixel(const Vec3f& pixel, bool clampNegative, std::array<double, 3>& radiance, ProbeSums& sums) {
  ++sums.pixels;
  if (!isFinite(pixel)) {
    ++sums.nonFinite;
    return false;
  }
  radiance = {static_cast<double>(pixel.x), static_cast<double>(pixel.y), static_cast<double>(pixel.z)};
  if (radiance[0] < 0 || radiance[1] < 0 || radiance[2] < 0) {
    ++sums.negative;
    if (clampNegative) {
      for (double& value : radiance) value = std::max(value, 0.0);
    }
  }
  return true;
}

}  // namespace shprt
