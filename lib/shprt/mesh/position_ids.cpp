#include "shprt/mesh/position_ids.h"

#include <cassert>

#include "shprt/mesh/distinct.h"

namespace shprt {

std::vector<std::uint32_t> distinctPositionIds(std::span<const Vec3f> positions) {
  return numberDistinct<3>(positions.size(),
                           [&](std::size_t i) {
                             const Vec3f p = positions[i];
                             return std::array{keyBits(p.x), keyBits(p.y), keyBits(p.z)};
                           })
      .ids;
}

std::vector<std::uint32_t> distinctPointIds(std::span<const Vec3f> positions,
                                            std::span<const Vec3f> normals) {
  assert(positions.size() == normals.size());
  return numberDistinct<6>(positions.size(),
                           [&](std::size_t i) {
                             const Vec3f p = positions[i], n = normals[i];
                             return std::array{keyBits(p.x), keyBits(p.y), keyBits(p.z),
                                               keyBits(n.x), keyBits(n.y), keyBits(n.z)};
                           })
      .ids;
}

}  // namespace shprt
