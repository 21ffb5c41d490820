// Environment maps from files, and which layout a picture has.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <tuple>
#include <utility>

#include "shprt/base/error.h"
#include "shprt/image/cube_faces.h"
#include "shprt/image/cube_layout.h"
#include "shprt/image/environment.h"

namespace shprt {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Balls leave the corners of their square black; the darkest grey of an 8-bit picture passes for it.
bool cornersAreBlack(const Image& image) {
  bool any = false;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double u = (2 * x + 1.0) / image.width - 1, v = (2 * y + 1.0) / image.height - 1;
      if (std::hypot(u, v) <= 1.02) continue;
      any = true;
      const Vec3f& pixel = image.at(x, y);
      if (!(pixel.x + pixel.y + pixel.z <= 1e-3f)) return false;
    }
  return any;
}

// The layout that a picture's metadata, name and shape speak for, and why. Throws Error when none does.
std::pair<EnvironmentLayout, std::string> guessLayout(const fs::path& path, const LoadedImage& loaded) {
  const auto [w, h] = std::pair(loaded.image.width, loaded.image.height);
  const std::string shape = std::to_string(w) + " x " + std::to_string(h);
  if (loaded.environmentKind == "latlong")
    return {EnvironmentLayout::kLatitudeLongitude, "EXR envmap attribute"};
  if (loaded.environmentKind == "cube") return {EnvironmentLayout::kOpenExrCube, "EXR envmap attribute"};
  const std::string name = lower(path.filename().string());
  const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
  if (has("mirror") && w == h) return {EnvironmentLayout::kMirroredBall, "its name, square"};
  if ((has("angular") || has("probe")) && w == h) return {EnvironmentLayout::kAngularMap, "its name, square"};
  if (w == 2 * h) return {EnvironmentLayout::kLatitudeLongitude, "2:1 shape"};
  if (3 * h == 4 * w) return {EnvironmentLayout::kVerticalCross, "3:4 shape"};
  if (4 * h == 3 * w) return {EnvironmentLayout::kHorizontalCross, "4:3 shape"};
  if (h == 6 * w) return {EnvironmentLayout::kCubeStrip, "1:6 shape"};
  if (w == 6 * h) return {EnvironmentLayout::kCubeStrip, "6:1 shape"};
  if (w == h && cornersAreBlack(loaded.image))
    return {EnvironmentLayout::kAngularMap, "square with black corners"};
  throw Error(path.string(), "no layout fits its " + shape + " pixels", "name one with --layout");
}

void checkShape(const fs::path& path, EnvironmentLayout layout, const Image& image) {
  const int w = image.width, h = image.height;
  bool fits = true;  // any latitude-longitude picture is at most a stretched one
  if (isCube(layout)) {
    const auto [columns, rows] = cubeCells(layout);
    fits = w % columns == 0 && h % rows == 0 && w / columns == h / rows;
  } else if (layout != EnvironmentLayout::kLatitudeLongitude) {
    fits = w == h;
  }
  if (fits) return;
  throw Error(path.string(),
              "its " + std::to_string(w) + " x " + std::to_string(h) + " pixels do not fit the layout " +
                  layoutName(layout),
              "name another with --layout");
}

}  // namespace

EnvironmentMap loadEnvironment(const fs::path& path, std::optional<EnvironmentLayout> layout) {
  std::error_code ignored;
  const bool manyFiles = fs::is_directory(path, ignored) || path.string().find("%s") != std::string::npos;
  if (manyFiles || !layout || layout == EnvironmentLayout::kCubeFaces) {
    const std::vector<fs::path> faces = findFaces(path);
    if (!faces.empty()) return loadFaces(path, faces);
    if (manyFiles || layout == EnvironmentLayout::kCubeFaces) {
      throw Error(path.string(), "holds no six faces",
                  "name them px nx py ny pz nz, posx negx ..., or right left top bottom front back");
    }
  }
  LoadedImage loaded = loadImage(path);
  EnvironmentMap map;
  map.notes = loaded.notes;
  map.sources.push_back(path);
  if (layout) {
    map.layout = *layout;
    map.layoutReason = "asked for";
  } else {
    std::tie(map.layout, map.layoutReason) = guessLayout(path, loaded);
  }
  if (map.layout == EnvironmentLayout::kCubeStrip && loaded.image.width == 6 * loaded.image.height)
    loaded.image = stackFaces(loaded.image);
  checkShape(path, map.layout, loaded.image);
  map.image = std::move(loaded.image);
  return map;
}

}  // namespace shprt
