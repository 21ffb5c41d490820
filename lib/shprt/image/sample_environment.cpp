// Radiance between pixels. A sample mixes only pixels that lie beside each other on the sphere: around the
// seam of a latitude-longitude picture, within the face of a cube, within the disc of a ball.

#include <algorithm>
#include <cmath>

#include "shprt/image/cube_layout.h"
#include "shprt/image/environment.h"

namespace shprt {
namespace {

// The pixels that a sample may use.
struct Bounds {
  int left, right, top, bottom;
};

Bounds boundsAt(const EnvironmentMap& map, PixelPosition position) {
  const int width = map.image.width, height = map.image.height;
  if (!isCube(map.layout)) return {0, width - 1, 0, height - 1};
  const int cell = std::max(1, width / cubeCells(map.layout).columns);
  const int left = std::clamp(static_cast<int>(position.x), 0, width - 1) / cell * cell,
            top = std::clamp(static_cast<int>(position.y), 0, height - 1) / cell * cell;
  return {left, std::min(left + cell, width) - 1, top, std::min(top + cell, height) - 1};
}

// Moves a position on a ball so far inside that all four pixels around it lie within the disc.
PixelPosition intoDisc(PixelPosition position, int width) {
  const double centre = width / 2.0, reach = std::max(centre - 1.5, 0.0);
  const double radius = std::hypot(position.x - centre, position.y - centre);
  if (radius <= reach) return position;
  return {centre + (position.x - centre) * reach / radius, centre + (position.y - centre) * reach / radius};
}

}  // namespace

Vec3f sampleEnvironment(const EnvironmentMap& map, Vec3d direction) {
  const Image& image = map.image;
  PixelPosition position = pixelPosition(map.layout, image.width, image.height, direction);
  if (map.layout == EnvironmentLayout::kAngularMap || map.layout == EnvironmentLayout::kMirroredBall)
    position = intoDisc(position, image.width);
  const Bounds bounds = boundsAt(map, position);
  const bool wraps = map.layout == EnvironmentLayout::kLatitudeLongitude;
  const auto at = [&](int x, int y) {
    x = wraps ? (x % image.width + image.width) % image.width : std::clamp(x, bounds.left, bounds.right);
    return image.at(x, std::clamp(y, bounds.top, bounds.bottom));
  };
  const double x = position.x - 0.5, y = position.y - 0.5;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const float fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
  return (at(x0, y0) * (1 - fx) + at(x0 + 1, y0) * fx) * (1 - fy) +
         (at(x0, y0 + 1) * (1 - fx) + at(x0 + 1, y0 + 1) * fx) * fy;
}

}  // namespace shprt
