// Pictures through OpenImageIO, which trusts headers: sizes are checked against the file before anything is
// allocated.

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "shprt/base/error.h"
#include "shprt/image/image.h"
#include "shprt/image/image_channels.h"
#include "shprt/image/image_file.h"

namespace shprt {
namespace {

// No format that is read here stores a large picture in less than its 2000th part, and none of this size does
// harm.
constexpr std::uint64_t kMostExpansion = 2000, kHarmlessPixels = std::uint64_t{1} << 22;
// 12 GB once loaded.
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 30;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& problem,
                       const std::string& remedy = "") {
  throw Error(path.string(), problem, remedy);
}

void checkSize(const std::filesystem::path& path, int width, int height) {
  const std::uint64_t bytes = std::filesystem::file_size(path);
  const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  const std::string claim = "claims " + std::to_string(width) + " x " + std::to_string(height) + " pixels, ";
  if (pixels > kHarmlessPixels && pixels / kMostExpansion > bytes)
    fail(path, claim + "more than its " + std::to_string(bytes) + " bytes can hold", "the file is damaged");
  if (pixels > kMostPixels)
    fail(path, claim + "more than the " + std::to_string(kMostPixels) + " that are read", "make it smaller");
}

void checkSpec(const std::filesystem::path& path, const OIIO::ImageSpec& spec) {
  if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.depth > 1 || spec.deep)
    fail(path, "has no pixels of a flat image", "give a flat image");
  if (spec.nchannels > 1024) fail(path, "claims " + std::to_string(spec.nchannels) + " channels");
  checkSize(path, spec.width, spec.height);
}

std::vector<Vec3f> readPixels(const std::filesystem::path& path, OIIO::ImageInput& input,
                              const OIIO::ImageSpec& spec, const std::array<int, 3>& channels) {
  std::vector<Vec3f> pixels(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height));
  const auto [first, last] = std::minmax({channels[0], channels[1], channels[2]});
  const auto read = [&](float* values) {
    // Some readers fill what a damaged file lacks, report success, and leave only a message.
    if (input.read_image(0, 0, first, last + 1, OIIO::TypeDesc::FLOAT, values) && !input.has_error()) return;
    const std::string reason = input.geterror().substr(0, 200);
    fail(path, "is damaged or truncated" + (reason.empty() ? "" : ": " + reason), "copy it again");
  };
  if (channels[1] == channels[0] + 1 && channels[2] == channels[0] + 2) {
    read(&pixels[0].x);
    return pixels;
  }
  const auto count = static_cast<std::size_t>(last - first + 1);
  std::vector<float> values(pixels.size() * count);
  read(values.data());
  const auto offset = [&](int channel) { return static_cast<std::size_t>(channel - first); };
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const float* pixel = &values[i * count];
    pixels[i] = {pixel[offset(channels[0])], pixel[offset(channels[1])], pixel[offset(channels[2])]};
  }
  return pixels;
}

// Puts the pixels where the file wants them to be shown: parts of the display window that it has no pixels
// for are black, pixels outside are dropped.
Image showInWindow(Image stored, const std::filesystem::path& path, const OIIO::ImageSpec& spec,
                   std::vector<std::string>& notes) {
  const int left = spec.x - spec.full_x, top = spec.y - spec.full_y;
  if (left == 0 && top == 0 && spec.full_width == stored.width && spec.full_height == stored.height)
    return stored;
  if (spec.full_width <= 0 || spec.full_height <= 0) return stored;
  checkSize(path, spec.full_width, spec.full_height);
  if (left >= spec.full_width || top >= spec.full_height || left + stored.width <= 0 ||
      top + stored.height <= 0)
    fail(path, "has no pixel inside its display window", "mend its data or display window");
  Image shown{spec.full_width, spec.full_height, {}};
  shown.pixels.resize(static_cast<std::size_t>(shown.width) * static_cast<std::size_t>(shown.height));
  for (int y = std::max(0, -top); y < stored.height && y + top < shown.height; ++y)
    for (int x = std::max(0, -left); x < stored.width && x + left < shown.width; ++x)
      shown.at(x + left, y + top) = stored.at(x, y);
  notes.push_back("its " + std::to_string(stored.width) + " x " + std::to_string(stored.height) +
                  " pixels placed in a display window of " + std::to_string(shown.width) + " x " +
                  std::to_string(shown.height));
  return shown;
}

// Turns a picture upright. orientation is the EXIF tag: 1 upright, 2 mirrored, 3 upside down, 4 both, 5 to 8
// the same with rows and columns exchanged.
Image turnUpright(Image stored, int orientation, std::vector<std::string>& notes) {
  if (orientation <= 1 || orientation > 8) return stored;
  const bool exchanged = orientation >= 5;
  const bool fromRight = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const bool fromBottom = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  Image upright{exchanged ? stored.height : stored.width, exchanged ? stored.width : stored.height, {}};
  upright.pixels.resize(stored.pixels.size());
  for (int y = 0; y < upright.height; ++y)
    for (int x = 0; x < upright.width; ++x) {
      const int column = exchanged ? y : x, row = exchanged ? x : y;
      upright.at(x, y) = stored.at(fromRight ? stored.width - 1 - column : column,
                                   fromBottom ? stored.height - 1 - row : row);
    }
  notes.push_back("turned upright as its orientation tag asks");
  return upright;
}

LoadedImage read(const std::filesystem::path& path, std::optional<ColourSpace> stored) {
  OIIO::ImageSpec hints;
  // PFM files begin with their lowest row, which some versions of OpenImageIO heed only when told.
  hints.attribute("pnm:pfmflip", 1);
  // Alpha is ignored, so colours stay as they are stored.
  hints.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path.string(), &hints);
  if (!input) {
    const std::string reason = OIIO::geterror();
    const bool unknown = reason.find("could not find a format reader") != std::string::npos;
    fail(path, "cannot be read as an image: " + (unknown ? "its format is not known" : reason.substr(0, 200)),
         "give a picture in a format that OpenImageIO reads");
  }
  const OIIO::ImageSpec spec = input->spec();
  checkSpec(path, spec);
  LoadedImage loaded;
  loaded.format = input->format_name();
  const std::string environment = spec.get_string_attribute("textureformat");
  if (environment == "LatLong Environment") loaded.environmentKind = "latlong";
  if (environment == "CubeFace Environment") loaded.environmentKind = "cube";
  std::vector<std::string> names;
  for (int channel = 0; channel < spec.nchannels; ++channel) names.emplace_back(spec.channel_name(channel));
  const ColourChannels channels = chooseColourChannels(names, loaded.format == "openexr", path.string());
  loaded.notes = channels.notes;
  loaded.image = {spec.width, spec.height, readPixels(path, *input, spec, channels.index)};
  const bool integers = !spec.format.is_floating_point();
  if (stored.value_or(integers ? ColourSpace::kSrgb : ColourSpace::kLinear) == ColourSpace::kSrgb) {
    loaded.notes.push_back(std::string(integers ? "integer" : "floating-point") +
                           " pixels decoded from sRGB to linear");
    for (Vec3f& pixel : loaded.image.pixels) pixel = decodeSrgb(pixel);
  }
  // OpenImageIO makes a display window of its own for cubes.
  if (loaded.environmentKind.empty())
    loaded.image = showInWindow(std::move(loaded.image), path, spec, loaded.notes);
  loaded.image = turnUpright(std::move(loaded.image), spec.get_int_attribute("Orientation", 1), loaded.notes);
  const bool more = input->seek_subimage(1, 0);
  input->geterror();  // OpenImageIO prints what nobody fetched
  if (more) loaded.notes.push_back("further pictures in the file ignored");
  return loaded;
}

}  // namespace

LoadedImage loadImage(const std::filesystem::path& path, std::optional<ColourSpace> stored) {
  checkImageFile(path);
  try {
    return read(path, stored);
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    fail(path, "needs more memory than there is", "make it smaller");
  } catch (const std::exception& problem) {
    fail(path, std::string("cannot be read as an image: ") + problem.what(), "the file is damaged");
  }
}

}  // namespace shprt
