// Parameterisations of the sphere by pictures: which direction each pixel shows, and the solid angle it
// covers. Right-handed world, +Y up (docs/conventions.md states each mapping, and docs/references.md where it
// comes from).
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/image/image.h"

namespace shprt {

enum class EnvironmentLayout {
  kLatitudeLongitude,
  kAngularMap,  // Debevec's light-probe ball: angle proportional to radius
  kMirroredBall,
  kVerticalCross,
  kHorizontalCross,
  kCubeFaces,    // six square images px nx py ny pz nz, as three.js and Filament show them; in memory a strip
  kCubeStrip,    // the same faces one below the other (1:6), or in a file also side by side (6:1)
  kOpenExrCube,  // 1:6 as OpenEXR's envmap attribute "cube" defines it
};

// "latlong", "angular", "mirrored-ball", "vertical-cross", "horizontal-cross", "faces", "strip", "exr-cube".
const char* layoutName(EnvironmentLayout layout);
// The layout of that name. Throws Error listing the names.
EnvironmentLayout parseLayout(const std::string& name);

struct PixelFootprint {
  Vec3d direction;        // unit, at the pixel's centre (at the rim of a ball: the mean over the part inside)
  double solidAngle = 0;  // of the part of the pixel that shows a direction; 0 where it shows none
};

// Where pixel (x, y) of a width x height picture in that layout looks. Solid angles are in closed form for
// rectangular layouts and integrated to 1e-10 of the sphere for balls; they sum to 4 pi over the picture.
PixelFootprint pixelFootprint(EnvironmentLayout layout, int width, int height, int x, int y);

// The pixel position (continuous, pixel centres at +0.5) that shows a unit direction.
struct PixelPosition {
  double x = 0, y = 0;
};
PixelPosition pixelPosition(EnvironmentLayout layout, int width, int height, Vec3d direction);

// A picture of the whole sphere.
struct EnvironmentMap {
  Image image;
  EnvironmentLayout layout = EnvironmentLayout::kLatitudeLongitude;
  std::string
      layoutReason;  // why that layout was taken: "asked for", "EXR envmap attribute", "2:1 shape", ...
  std::vector<std::string> notes;
  std::vector<std::filesystem::path> sources;
};

// Loads an environment map. layout empty means auto: EXR envmap attribute, then the file's name ("mirror",
// "probe", "angular") when it is square, then its shape. For kCubeFaces path names one face (px/nx/...,
// posx/negx, right/left/...), a folder of six, or a pattern with %s; faces become a strip in memory. Throws
// Error when nothing fits.
EnvironmentMap loadEnvironment(const std::filesystem::path& path,
                               std::optional<EnvironmentLayout> layout = {});

// Bilinear radiance seen in a unit direction (nearest at the edges of layouts that have edges).
Vec3f sampleEnvironment(const EnvironmentMap& map, Vec3d direction);

}  // namespace shprt
