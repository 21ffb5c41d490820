// Environment maps painted with functions of direction, in every layout.
#pragma once

#include <cstddef>
#include <vector>

#include "shprt/image/environment.h"

namespace shprt {

struct PaintedCase {
  EnvironmentLayout layout;
  int width, height;
};
// As many pixels on the sphere as 512 x 256.
inline const PaintedCase kPaintedCases[] = {
    {EnvironmentLayout::kLatitudeLongitude, 512, 256}, {EnvironmentLayout::kAngularMap, 408, 408},
    {EnvironmentLayout::kMirroredBall, 408, 408},      {EnvironmentLayout::kVerticalCross, 444, 592},
    {EnvironmentLayout::kHorizontalCross, 592, 444},   {EnvironmentLayout::kCubeStrip, 148, 888},
    {EnvironmentLayout::kOpenExrCube, 148, 888}};

// Pixels that show no direction stay black.
template <typename Function>
EnvironmentMap paintMap(const PaintedCase& c, const Function& radiance) {
  EnvironmentMap map;
  map.layout = c.layout;
  map.image = {c.width, c.height,
               std::vector<Vec3f>(static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.height))};
  for (int y = 0; y < c.height; ++y)
    for (int x = 0; x < c.width; ++x) {
      const PixelFootprint footprint = pixelFootprint(c.layout, c.width, c.height, x, y);
      if (footprint.solidAngle > 0) map.image.at(x, y) = radiance(footprint.direction);
    }
  return map;
}

}  // namespace shprt
