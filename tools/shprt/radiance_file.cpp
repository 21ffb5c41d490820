#include "radiance_file.h"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>

namespace shprt {
namespace {

void appendArray(fmt::memory_buffer& text, const char* name, std::span<const Vec3f> values) {
  fmt::format_to(std::back_inserter(text), ",\n\"{}\":[", name);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Vec3f& v = values[i];
    fmt::format_to(std::back_inserter(text), "{}[{},{},{}]", i == 0 ? "\n" : ",\n", v.x, v.y, v.z);
  }
  fmt::format_to(std::back_inserter(text), "]");
}

}  // namespace

std::string formatRadianceCsv(const TransferAsset& asset, std::span<const Vec3f> radiance,
                              std::span<const Vec3f> standardErrors) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "x,y,z,nx,ny,nz,r,g,b{}\n",
                 standardErrors.empty() ? "" : ",r_error,g_error,b_error");
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const Vec3f &p = asset.positions[i], &n = asset.normals[i], &c = radiance[i];
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{}", p.x, p.y, p.z, n.x, n.y, n.z, c.x,
                   c.y, c.z);
    if (!standardErrors.empty()) {
      const Vec3f& e = standardErrors[i];
      fmt::format_to(std::back_inserter(text), ",{},{},{}", e.x, e.y, e.z);
    }
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

std::string formatRadianceJson(const TransferAsset& asset, std::span<const Vec3f> radiance,
                               std::span<const Vec3f> standardErrors) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{{\"format\":\"shprt-radiance\",\"version\":1,\"vertexCount\":{}",
                 radiance.size());
  appendArray(text, "positions", asset.positions);
  appendArray(text, "normals", asset.normals);
  appendArray(text, "radiance", radiance);
  if (!standardErrors.empty()) appendArray(text, "standardErrors", standardErrors);
  fmt::format_to(std::back_inserter(text), "}}\n");
  return fmt::to_string(text);
}

}  // namespace shprt
