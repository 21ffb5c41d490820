// Based on: the OpenEXR file layout: magic number and version, then one list of attributes (name, type, size,
// content) per part, each closed by a zero byte; multi-part files close the lists with another.

#include "shprt/base/exr_header.h"

#include <bit>
#include <cstdint>
#include <fstream>
#include <system_error>

#include "shprt/base/file.h"

namespace shprt {
namespace {

static_assert(std::endian::native == std::endian::little, "OpenEXR files are little-endian");

constexpr std::uint32_t kMultiPartFlag = 0x1000;
constexpr int kLongestName = 255;

class HeaderWalk {
 public:
  HeaderWalk(const std::filesystem::path& path, std::uint64_t bytes)
      : file_(path, std::ios::binary), bytes_(bytes) {}

  bool fits() {
    file_.seekg(4);
    const bool manyParts = (readWord() & kMultiPartFlag) != 0;
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

  // Leaves the file behind the name's zero byte.
  bool skipName() {
    for (int length = 0; length <= kLongestName; ++length) {
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

bool isExrFile(const std::filesystem::path& path) {
  return readFirstBytes(path, 4) == "\x76\x2f\x31\x01";
}

bool hasWholeExrHeader(const std::filesystem::path& path) {
  std::error_code problem;
  const std::uint64_t bytes = std::filesystem::file_size(path, problem);
  return !problem && HeaderWalk(path, bytes).fits();
}

}  // namespace shprt
