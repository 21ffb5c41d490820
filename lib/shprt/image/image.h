// Pictures in memory, and the one door to OpenImageIO.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/image/colour_space.h"

namespace shprt {

// Linear Rec.709 RGB, rows from the top, pixels from the left.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Vec3f> pixels;  // width * height

  Vec3f& at(int x, int y) {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  const Vec3f& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

struct LoadedImage {
  Image image;
  std::string format;              // OpenImageIO's name of the format: "openexr", "hdr", "png", ...
  std::string environmentKind;     // EXR envmap attribute: "latlong", "cube", or "" when there is none
  std::vector<std::string> notes;  // conversions made: "sRGB decoded to linear", "one channel, used for all
                                   // three", "alpha ignored"
};

// Reads the first image of a file. 8- and 16-bit integer pictures are decoded from sRGB; one channel serves
// all three; alpha and further channels are ignored, with a note. NaN and infinities are kept for the caller
// to judge. stored: what the numbers in the file are, where something else than the above is known. Checks
// the header against the file's size before allocating. Throws Error.
LoadedImage loadImage(const std::filesystem::path& path, std::optional<ColourSpace> stored = {});

// Writes .exr (half or float, linear) or .png/.jpg/... (the values are written as they are, clamped to [0,1],
// 8 bits: encode to sRGB first, see picture/tone_map.h), .hdr (linear). Atomic. Throws Error (unknown suffix,
// no space).
void saveImage(const std::filesystem::path& path, const Image& image);

}  // namespace shprt
