#include "shprt/scene/texture_set.h"

#include <algorithm>

namespace shprt {

std::uint32_t TextureSet::load(const std::filesystem::path& path, std::optional<ColourSpace> stored) {
  std::error_code ignored;  // what cannot be found is said by whoever opens it
  const auto key = std::pair(std::filesystem::weakly_canonical(path, ignored), stored);
  if (const auto known = numbers_.find(key); known != numbers_.end()) return known->second;
  LoadedImage loaded = loadImage(path, stored);
  std::uint64_t outside = 0;
  for (Vec3f& pixel : loaded.image.pixels) {
    const Vec3f given = pixel;
    // The order of arguments makes 0 of NaN.
    const auto toUnit = [](float value) { return std::min(1.0f, std::max(0.0f, value)); };
    pixel = {toUnit(pixel.x), toUnit(pixel.y), toUnit(pixel.z)};
    outside += pixel != given;
  }
  const std::string name = path.filename().string();
  for (const std::string& note : loaded.notes) notes_.push_back(name + ": " + note);
  if (outside) notes_.push_back(name + ": " + std::to_string(outside) + " pixels clamped to [0,1]");
  const auto number = static_cast<std::uint32_t>(images_.size());
  images_.push_back(std::move(loaded.image));
  sources_.push_back(path);
  numbers_.emplace(key, number);
  return number;
}

}  // namespace shprt
