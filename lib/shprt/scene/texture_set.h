// The textures of a scene, each read once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shprt/image/image.h"

namespace shprt {

class TextureSet {
 public:
  // The number of the picture among images(), which is read on first use and clamped to [0,1], what is no
  // number to 0. stored: as for loadImage. Throws Error when it cannot be read.
  std::uint32_t load(const std::filesystem::path& path, std::optional<ColourSpace> stored);

  std::vector<Image>& images() { return images_; }
  const std::vector<std::filesystem::path>& sources() const { return sources_; }
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::map<std::pair<std::filesystem::path, std::optional<ColourSpace>>, std::uint32_t> numbers_;
  std::vector<Image> images_;
  std::vector<std::filesystem::path> sources_;
  std::vector<std::string> notes_;
};

}  // namespace shprt
