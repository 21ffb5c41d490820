// Six faces from six files, or from a strip that lies on its side.

#include "shprt/image/cube_faces.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "shprt/base/error.h"

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

}  // namespace

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

Image stackFaces(const Image& strip) {
  const int size = strip.height;
  Image stacked{size, 6 * size, {}};
  stacked.pixels.reserve(strip.pixels.size());
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) stacked.pixels.push_back(strip.at(face * size + x, y));
  return stacked;
}

}  // namespace shprt
