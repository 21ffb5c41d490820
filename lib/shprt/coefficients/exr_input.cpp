// The header walk rests on the OpenEXR file layout: magic number and version, then one list of attributes
// (name, type, size, content) per part, each closed by a zero byte; multi-part files close the lists with
// another.

#include "shprt/coefficients/exr_input.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfVersion.h>

#include <bit>
#include <cstdint>
#include <fstream>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/coefficients/asset_file.h"

namespace shprt {
namespace {

static_assert(std::endian::native == std::endian::little, "OpenEXR files are little-endian");

class HeaderWalk {
 public:
  explicit HeaderWalk(const std::filesystem::path& path)
      : file_(path, std::ios::binary), bytes_(std::filesystem::file_size(path)) {}

  // Whether every attribute lies inside the file.
  bool fits() {
    file_.seekg(4);
    const std::uint32_t version = readWord();
    const bool manyParts = (version & Imf::MULTI_PART_FILE_FLAG) != 0;
    do {
      if (!skipAttributes()) return false;
    } while (manyParts && file_.peek() != 0);
    return true;
  }

 private:
  std::uint32_t readWord() {
    std::uint32_t word = 0;
    file_.read(reinterpret_cast<char*>(&word), sizeof word);
    return word;
  }

  // Leaves the file behind the name's zero byte. OpenEXR allows 255 characters.
  bool skipName() {
    for (int length = 0; length <= 255; ++length) {
      if (file_.get() == 0) return true;
      if (!file_) return false;
    }
    return false;
  }

  bool skipAttributes() {
    while (file_.peek() != 0) {
      if (!skipName() || !skipName()) return false;
      const std::uint32_t size = readWord();
      if (!file_ || size > bytes_ - static_cast<std::uint64_t>(file_.tellg())) return false;
      file_.seekg(size, std::ios::cur);
    }
    return file_.get() == 0;
  }

  std::ifstream file_;
  std::uint64_t bytes_;
};

}  // namespace

std::unique_ptr<Imf::MultiPartInputFile> openExr(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) throw Error(path.string(), "no such file", "check the path");
  if (!isExrFile(path)) throw Error(path.string(), "is no OpenEXR file", "give an asset made by shprt bake");
  try {
    if (HeaderWalk(path).fits()) return std::make_unique<Imf::MultiPartInputFile>(path.c_str(), 0, false);
  } catch (const std::exception&) {
    // OpenEXR's messages name its own internals; what helps the user is below.
  }
  throw Error(path.string(), "is a damaged or truncated OpenEXR file", "bake it again");
}

int width(const Imf::Header& header) {
  return header.dataWindow().max.x - header.dataWindow().min.x + 1;
}

int height(const Imf::Header& header) {
  return header.dataWindow().max.y - header.dataWindow().min.y + 1;
}

std::string channelNames(const Imf::Header& header) {
  std::string names;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    names += (names.empty() ? "" : ",") + std::string(channel.name());
  }
  return names;
}

bool isExrFile(const std::filesystem::path& path) {
  return readFirstBytes(path, 4) == "\x76\x2f\x31\x01";
}

}  // namespace shprt
