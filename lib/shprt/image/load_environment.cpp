// Environment maps from files: which layout a picture has, and six faces put into one strip.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <tuple>
#include <utility>

#include "shprt/base/error.h"
#include "shprt/image/environment.h"

namespace shprt {
namespace {

namespace fs = std::filesystem;

// Names of the six faces, in the order of the strip.
constexpr std::array<std::array<const char*, 6>, 3> kFaceNames = {
    {{"px", "nx", "py", "ny", "pz", "nz"},
     {"posx", "negx", "posy", "negy", "posz", "negz"},
     {"right", "left", "top", "bottom", "front", "back"}}};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Whether a file's stem is a face name, alone or behind a separator: "px", "sky_px", "sky.px", "sky-px".
bool namesFace(const fs::path& file, const std::string& face) {
  const std::string stem = lower(file.stem().string());
  if (stem == face) return true;
  if (!stem.ends_with(face)) return false;
  const char before = stem[stem.size() - face.size() - 1];
  return before == '_' || before == '.' || before == '-';
}

// The six files that belong to a folder, a pattern with %s, or one of the faces; empty when there are none.
std::vector<fs::path> findFaces(const fs::path& path) {
  const std::size_t mark = path.string().find("%s");
  std::error_code ignored;
  for (const auto& names : kFaceNames) {
    std::vector<fs::path> faces;
    for (const char* name : names) {
      if (mark != std::string::npos) {
        const fs::path face = path.string().substr(0, mark) + name + path.string().substr(mark + 2);
        if (fs::is_regular_file(face, ignored)) faces.push_back(face);
      } else if (fs::is_directory(path, ignored)) {
        for (const auto& entry : fs::directory_iterator(path, ignored)) {
          if (entry.is_regular_file(ignored) && namesFace(entry.path(), name)) faces.push_back(entry.path());
        }
      } else {
        for (const char* given : names) {
          if (!namesFace(path, given)) continue;
          const std::string stem = path.stem().string();
          const std::string prefix = stem.substr(0, stem.size() - std::string(given).size());
          const fs::path face = path.parent_path() / (prefix + name + path.extension().string());
          if (fs::is_regular_file(face, ignored)) faces.push_back(face);
        }
      }
    }
    if (faces.size() == 6) return faces;
  }
  return {};
}

EnvironmentMap loadFaces(const fs::path& path, const std::vector<fs::path>& faces) {
  EnvironmentMap map;
  map.layout = EnvironmentLayout::kCubeFaces;
  for (const fs::path& face : faces) {
    const LoadedImage loaded = loadImage(face);
    if (loaded.image.width != loaded.image.height)
      throw Error(face.string(), "is not square", "give square faces");
    if (map.image.width == 0) map.image.width = loaded.image.width;
    if (loaded.image.width != map.image.width)
      throw Error(face.string(), "is of another size than the faces before it", "give six faces of one size");
    map.image.pixels.insert(map.image.pixels.end(), loaded.image.pixels.begin(), loaded.image.pixels.end());
    if (map.notes.empty()) map.notes = loaded.notes;
    map.sources.push_back(face);
  }
  map.image.height = 6 * map.image.width;
  map.layoutReason = "six faces beside each other, " + path.string();
  return map;
}

// Balls leave the corners of their square black.
bool cornersAreBlack(const Image& image) {
  bool any = false;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double u = (2 * x + 1.0) / image.width - 1, v = (2 * y + 1.0) / image.height - 1;
      const Vec3f& pixel = image.at(x, y);
      if (std::hypot(u, v) <= 1.02) continue;
      any = true;
      if (pixel.x + pixel.y + pixel.z > 1e-3f) return false;
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
  if (w == h && cornersAreBlack(loaded.image))
    return {EnvironmentLayout::kAngularMap, "square with black corners"};
  throw Error(path.string(), "no layout fits its " + shape + " pixels", "name one with --layout");
}

void checkShape(const fs::path& path, EnvironmentLayout layout, const Image& image) {
  const int w = image.width, h = image.height;
  bool fits = true;
  switch (layout) {
    case EnvironmentLayout::kVerticalCross:
      fits = w % 3 == 0 && h % 4 == 0 && w / 3 == h / 4;
      break;
    case EnvironmentLayout::kHorizontalCross:
      fits = w % 4 == 0 && h % 3 == 0 && w / 4 == h / 3;
      break;
    case EnvironmentLayout::kCubeStrip:
    case EnvironmentLayout::kCubeFaces:
    case EnvironmentLayout::kOpenExrCube:
      fits = h == 6 * w;
      break;
    case EnvironmentLayout::kAngularMap:
    case EnvironmentLayout::kMirroredBall:
      fits = w == h;
      break;
    case EnvironmentLayout::kLatitudeLongitude:
      break;  // any shape is a stretched one
  }
  if (!fits) {
    throw Error(path.string(),
                std::string("its ") + std::to_string(w) + " x " + std::to_string(h) +
                    " pixels do not fit the layout " + layoutName(layout),
                "name another with --layout");
  }
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
  checkShape(path, map.layout, loaded.image);
  map.image = std::move(loaded.image);
  return map;
}

Vec3f sampleEnvironment(const EnvironmentMap& map, Vec3d direction) {
  const Image& image = map.image;
  PixelPosition position = pixelPosition(map.layout, image.width, image.height, direction);
  if (map.layout == EnvironmentLayout::kAngularMap || map.layout == EnvironmentLayout::kMirroredBall) {
    // All four pixels around a sample must lie inside the disc.
    const double centre = image.width / 2.0, reach = std::max(centre - 1.5, 0.0);
    const double radius = std::hypot(position.x - centre, position.y - centre);
    if (radius > reach)
      position = {centre + (position.x - centre) * reach / radius,
                  centre + (position.y - centre) * reach / radius};
  }
  const double x = position.x - 0.5, y = position.y - 0.5;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const float fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
  const bool wraps = map.layout == EnvironmentLayout::kLatitudeLongitude;
  // The cell of a cube's face that the sample may not leave; the whole picture elsewhere.
  int left = 0, right = image.width - 1, top = 0, bottom = image.height - 1;
  if (map.layout != EnvironmentLayout::kLatitudeLongitude && map.layout != EnvironmentLayout::kAngularMap &&
      map.layout != EnvironmentLayout::kMirroredBall) {
    const int columns = map.layout == EnvironmentLayout::kVerticalCross     ? 3
                        : map.layout == EnvironmentLayout::kHorizontalCross ? 4
                                                                            : 1;
    const int cell = image.width / columns;
    left = std::clamp(static_cast<int>(position.x), 0, image.width - 1) / cell * cell;
    top = std::clamp(static_cast<int>(position.y), 0, image.height - 1) / cell * cell;
    right = left + cell - 1;
    bottom = top + cell - 1;
  }
  const auto at = [&](int px, int py) {
    px = wraps ? (px % image.width + image.width) % image.width : std::clamp(px, left, right);
    return image.at(px, std::clamp(py, top, bottom));
  };
  return (at(x0, y0) * (1 - fx) + at(x0 + 1, y0) * fx) * (1 - fy) +
         (at(x0, y0 + 1) * (1 - fx) + at(x0 + 1, y0 + 1) * fx) * fy;
}

}  // namespace shprt
