// Pictures through OpenImageIO, which trusts headers: sizes are checked against the file before anything is
// allocated.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <string_view>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/image/image.h"

namespace shprt {
namespace {

// No format that is read here stores a pixel in less than its 2000th part.
constexpr std::uint64_t kMostExpansion = 2000;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& problem,
                       const std::string& remedy = "") {
  throw Error(path.string(), problem, remedy);
}

void checkIsFile(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status)) fail(path, "no such file", "check the path");
  if (std::filesystem::is_directory(status)) fail(path, "is a directory", "give an image file");
  if (!std::filesystem::is_regular_file(status))
    fail(path, "is a pipe or device", "save its content to a file first");
  if (std::filesystem::file_size(path, ignored) == 0) fail(path, "is empty", "give an image file");
  if (isLfsPointer(readFirstBytes(path, 64))) {
    fail(path, "is a git-LFS pointer, not an image", "fetch it with: git lfs pull");
  }
}

// libpng reports damage on standard error by itself, so a PNG's chunks are walked before it sees them.
bool isCutPng(const std::filesystem::path& path) {
  constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
  std::ifstream file(path, std::ios::binary);
  char head[8] = {};
  if (!file.read(head, 8) || std::string_view(head, 8) != kSignature) return false;
  const std::uint64_t size = std::filesystem::file_size(path);
  std::uint64_t at = 8;
  while (at + 12 <= size) {
    unsigned char chunk[8];
    file.seekg(static_cast<std::streamoff>(at));
    if (!file.read(reinterpret_cast<char*>(chunk), 8)) return true;
    const std::uint64_t length = std::uint64_t{chunk[0]} << 24 | std::uint64_t{chunk[1]} << 16 |
                                 std::uint64_t{chunk[2]} << 8 | chunk[3];
    at += 12 + length;
    if (std::string_view(reinterpret_cast<char*>(chunk) + 4, 4) == "IEND") return at > size;
  }
  return true;
}

// The end of a channel name like "left.R".
std::string baseName(const std::string& channel) {
  std::string name = channel.substr(channel.rfind('.') + 1);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

// Which channels serve as red, green and blue.
std::array<int, 3> chooseChannels(const OIIO::ImageSpec& spec, std::vector<std::string>& notes) {
  std::array<int, 3> chosen = {-1, -1, -1};
  constexpr std::array<const char*, 3> kShort = {"R", "G", "B"}, kLong = {"RED", "GREEN", "BLUE"};
  for (int channel = 0; channel < spec.nchannels; ++channel) {
    const std::string name = channel < static_cast<int>(spec.channelnames.size())
                                 ? baseName(spec.channelnames[static_cast<std::size_t>(channel)])
                                 : "";
    for (std::size_t colour = 0; colour < 3; ++colour) {
      if (chosen[colour] < 0 && (name == kShort[colour] || name == kLong[colour])) chosen[colour] = channel;
    }
  }
  const bool named = chosen[0] >= 0 && chosen[1] >= 0 && chosen[2] >= 0;
  if (!named) chosen = spec.nchannels >= 3 ? std::array<int, 3>{0, 1, 2} : std::array<int, 3>{0, 0, 0};
  if (chosen[0] == chosen[1]) notes.push_back("one channel, used for all three colours");
  const int others = spec.nchannels - (chosen[0] == chosen[1] ? 1 : 3);
  if (others > 0)
    notes.push_back(std::to_string(others) +
                    (others == 1 ? " further channel ignored" : " further channels ignored"));
  return chosen;
}

// Based on: IEC 61966-2-1.
float decodeSrgb(float value) {
  return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

}  // namespace

LoadedImage loadImage(const std::filesystem::path& path) {
  checkIsFile(path);
  if (isCutPng(path)) fail(path, "is a truncated or damaged PNG file", "copy it again");
  LoadedImage loaded;
  try {
    // PFM files begin with their lowest row, which some versions of OpenImageIO heed only when told.
    OIIO::ImageSpec hints;
    hints.attribute("pnm:pfmflip", 1);
    const auto input = OIIO::ImageInput::open(path.string(), &hints);
    if (!input) {
      const std::string reason = OIIO::geterror();
      fail(path, "cannot be read as an image: " + reason.substr(0, 200),
           "give a picture in a format that OpenImageIO reads");
    }
    const OIIO::ImageSpec& spec = input->spec();
    const std::uint64_t bytes = std::filesystem::file_size(path);
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.depth > 1)
      fail(path, "has no pixels of a flat image");
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
    if (pixels / kMostExpansion > bytes || spec.nchannels > 1024) {
      fail(path,
           "claims " + std::to_string(spec.width) + " x " + std::to_string(spec.height) +
               " pixels, more than its " + std::to_string(bytes) + " bytes can hold",
           "the file is damaged");
    }
    loaded.format = input->format_name();
    const std::string environment = spec.get_string_attribute("textureformat");
    if (environment == "LatLong Environment") loaded.environmentKind = "latlong";
    if (environment == "CubeFace Environment") loaded.environmentKind = "cube";
    const std::array<int, 3> channels = chooseChannels(spec, loaded.notes);
    const int channelsRead = *std::max_element(channels.begin(), channels.end()) + 1;
    std::vector<float> values(pixels * static_cast<std::uint64_t>(channelsRead));
    if (!input->read_image(0, 0, 0, channelsRead, OIIO::TypeDesc::FLOAT, values.data())) {
      const std::string reason = input->geterror().substr(0, 200);
      fail(path, "is damaged or truncated" + (reason.empty() ? "" : ": " + reason), "copy it again");
    }
    const bool encoded = spec.format.is_floating_point() == false;
    if (encoded) loaded.notes.push_back("integer pixels decoded from sRGB to linear");
    loaded.image.width = spec.width;
    loaded.image.height = spec.height;
    loaded.image.pixels.resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
      const float* pixel = &values[i * static_cast<std::size_t>(channelsRead)];
      const auto channel = [&](std::size_t colour) {
        const float value = pixel[channels[colour]];
        return encoded ? decodeSrgb(value) : value;
      };
      loaded.image.pixels[i] = {channel(0), channel(1), channel(2)};
    }
  } catch (const Error&) {
    throw;
  } catch (const std::exception& problem) {
    fail(path, std::string("cannot be read as an image: ") + problem.what(), "the file is damaged");
  }
  return loaded;
}

void saveImage(const std::filesystem::path& path, const Image& image) {
  const std::string suffix = path.extension().string();
  const bool linear = suffix == ".exr" || suffix == ".hdr";
  const auto output = OIIO::ImageOutput::create(path.string());
  if (!output) fail(path, "has a suffix that is no image format", "use .png, .exr, .hdr or .jpg");
  OIIO::ImageSpec spec(image.width, image.height, 3, linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  if (suffix == ".exr") spec.attribute("compression", "zip");
  spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
  // Formats hide what goes wrong while a file is closed; written to memory first, nothing can, and the file
  // is ours to write.
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  if (!output->supports("ioproxy") || !output->set_ioproxy(&memory))
    fail(path, "is of a format that cannot be written here", "use .png, .exr, .hdr or .jpg");
  bool good = output->open(path.string(), spec);
  good = good && output->write_image(OIIO::TypeDesc::FLOAT, image.pixels.data());
  good = output->close() && good;
  if (!good) fail(path, "cannot be encoded: " + output->geterror().substr(0, 200));
  writeFile(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace shprt
