#include "shprt/mesh/write_ply.h"

#include <bit>
#include <cassert>
#include <cstring>
#include <string>

#include "shprt/base/file.h"

namespace shprt {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY is written as the machine has its numbers");

constexpr const char* kErrorProperties =
    "property float radiance_error_r\nproperty float radiance_error_g\nproperty float radiance_error_b\n";

template <typename T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

void writePly(const std::filesystem::path& path, std::span<const Vec3f> positions,
              std::span<const Vec3f> normals, std::span<const std::array<std::uint8_t, 3>> colours8,
              std::span<const Vec3f> radiance, std::span<const Triangle> triangles,
              std::span<const Vec3f> standardErrors) {
  assert(normals.size() == positions.size() && colours8.size() == positions.size() &&
         radiance.size() == positions.size() &&
         (standardErrors.empty() || standardErrors.size() == positions.size()));
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\ncomment relit by shprt: red green blue are sRGB, radiance_* "
      "linear Rec.709\nelement vertex " +
      std::to_string(positions.size()) +
      "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float "
      "ny\nproperty float nz\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "property float radiance_r\nproperty float radiance_g\nproperty float radiance_b\n" +
      (standardErrors.empty() ? "" : kErrorProperties) + "element face " + std::to_string(triangles.size()) +
      "\nproperty list uchar int vertex_indices\nend_header\n";
  bytes.reserve(bytes.size() + positions.size() * (standardErrors.empty() ? 39 : 51) + triangles.size() * 13);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    append(bytes, positions[v]);
    append(bytes, normals[v]);
    append(bytes, colours8[v]);
    append(bytes, radiance[v]);
    if (!standardErrors.empty()) append(bytes, standardErrors[v]);
  }
  for (const Triangle& triangle : triangles) {
    bytes += '\3';
    append(bytes, triangle);
  }
  writeFile(path, bytes);
}

}  // namespace shprt
