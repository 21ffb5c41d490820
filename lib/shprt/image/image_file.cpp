// Files that would come out of OpenImageIO with a misleading message, or with one on standard error.

#include "shprt/image/image_file.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

#include "shprt/base/error.h"
#include "shprt/base/exr_header.h"
#include "shprt/base/file.h"

namespace shprt {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

// The checksum of PNG chunks. Based on: ISO 15948, annex D.
std::uint32_t crc32(std::string_view bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t entry = n;
      for (int bit = 0; bit < 8; ++bit) entry = (entry >> 1) ^ (entry % 2 != 0 ? 0xedb88320u : 0u);
      entries[n] = entry;
    }
    return entries;
  }();
  std::uint32_t crc = ~0u;
  for (const char byte : bytes) crc = table[(crc ^ static_cast<unsigned char>(byte)) % 256] ^ (crc >> 8);
  return ~crc;
}

std::uint32_t bigEndian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes.substr(0, 4)) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

// libpng reports damage on standard error by itself, so a PNG's chunks are walked before it sees them.
bool isDamagedPng(const std::filesystem::path& path) {
  const std::string content = readFile(path);
  if (!content.starts_with(kPngSignature)) return true;
  std::string_view rest = std::string_view(content).substr(kPngSignature.size());
  while (rest.size() >= 12) {
    const std::uint64_t length = bigEndian(rest);
    if (length + 12 > rest.size()) return true;
    const std::string_view typeAndData = rest.substr(4, 4 + length);
    if (crc32(typeAndData) != bigEndian(rest.substr(8 + length))) return true;
    if (typeAndData.starts_with("IEND")) return false;
    rest.remove_prefix(12 + length);
  }
  return true;
}

}  // namespace

void checkImageFile(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status)) throw Error(name, "no such file", "check the path");
  if (std::filesystem::is_directory(status)) throw Error(name, "is a directory", "give an image file");
  if (!std::filesystem::is_regular_file(status))
    throw Error(name, "is a pipe or device", "save its content to a file first");
  if (std::filesystem::file_size(path, ignored) == 0) throw Error(name, "is empty", "give an image file");
  const std::string start = readFirstBytes(path, 64);
  if (start.empty()) throw Error(name, "cannot be opened", "check its permissions");
  if (isLfsPointer(start))
    throw Error(name, "is a git-LFS pointer, not an image", "fetch it with: git lfs pull");
  if (start.size() > 4 && start.substr(1, 3) == "PNG" && isDamagedPng(path))
    throw Error(name, "is a truncated or damaged PNG file", "copy it again");
  if (isExrFile(path) && !hasWholeExrHeader(path))
    throw Error(name, "is a truncated or damaged OpenEXR file", "copy it again");
}

}  // namespace shprt
