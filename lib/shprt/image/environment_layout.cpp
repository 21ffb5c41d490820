// Names of the layouts, and the mapping of each. All pictures show the sphere as seen from inside it, not
// mirrored, with +Y up and +Z in the middle; so +X lies to the left (the frame is right-handed). Mirrored
// balls show what the ball reflects: the camera looks along +Z, and the middle of the ball shows -Z, the
// direction back to it. Based on: OpenEXR environment maps (latitude-longitude).

#include <cmath>
#include <numbers>

#include "shprt/base/error.h"
#include "shprt/image/ball_layout.h"
#include "shprt/image/cube_layout.h"
#include "shprt/image/environment.h"

namespace shprt {
namespace {

using std::numbers::pi;

struct NamedLayout {
  EnvironmentLayout layout;
  const char* name;
};
constexpr NamedLayout kLayouts[] = {{EnvironmentLayout::kLatitudeLongitude, "latlong"},
                                    {EnvironmentLayout::kAngularMap, "angular"},
                                    {EnvironmentLayout::kMirroredBall, "mirrored-ball"},
                                    {EnvironmentLayout::kVerticalCross, "vertical-cross"},
                                    {EnvironmentLayout::kHorizontalCross, "horizontal-cross"},
                                    {EnvironmentLayout::kCubeFaces, "faces"},
                                    {EnvironmentLayout::kCubeStrip, "strip"},
                                    {EnvironmentLayout::kOpenExrCube, "exr-cube"}};

PixelFootprint latitudeLongitudeFootprint(int width, int height, int x, int y) {
  const double top = pi * y / height, bottom = pi * (y + 1) / height;
  const double theta = (top + bottom) / 2, phi = pi * (1 - 2 * (x + 0.5) / width);
  // cos(top) - cos(bottom), without cancellation
  const double band = 2 * std::sin(theta) * std::sin((bottom - top) / 2);
  return {{std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)},
          2 * pi / width * band};
}

}  // namespace

const char* layoutName(EnvironmentLayout layout) {
  for (const NamedLayout& known : kLayouts) {
    if (known.layout == layout) return known.name;
  }
  return "";
}

EnvironmentLayout parseLayout(const std::string& name) {
  std::string names;
  for (const NamedLayout& known : kLayouts) {
    if (name == known.name) return known.layout;
    names += std::string(names.empty() ? "" : ", ") + known.name;
  }
  throw Error("layout '" + name + "'", "is not known", "use one of " + names);
}

PixelFootprint pixelFootprint(EnvironmentLayout layout, int width, int height, int x, int y) {
  switch (layout) {
    case EnvironmentLayout::kLatitudeLongitude:
      return latitudeLongitudeFootprint(width, height, x, y);
    case EnvironmentLayout::kAngularMap:
      return ballFootprint(Ball::kAngular, width, height, x, y);
    case EnvironmentLayout::kMirroredBall:
      return ballFootprint(Ball::kMirrored, width, height, x, y);
    default:
      return cubeFootprint(layout, width, height, x, y);
  }
}

PixelPosition pixelPosition(EnvironmentLayout layout, int width, int height, Vec3d direction) {
  switch (layout) {
    case EnvironmentLayout::kLatitudeLongitude: {
      const double theta = std::atan2(std::hypot(direction.x, direction.z), direction.y),
                   phi = std::atan2(direction.x, direction.z);
      return {(1 - phi / pi) / 2 * width, theta / pi * height};
    }
    case EnvironmentLayout::kAngularMap:
      return ballPosition(Ball::kAngular, width, height, direction);
    case EnvironmentLayout::kMirroredBall:
      return ballPosition(Ball::kMirrored, width, height, direction);
    default:
      return cubePosition(layout, width, height, direction);
  }
}

}  // namespace shprt
