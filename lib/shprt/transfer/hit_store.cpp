#include "shprt/transfer/hit_store.h"

#include <algorithm>
#include <cmath>

namespace shprt {
namespace {

int toSteps(float share) {
  return static_cast<int>(std::lround(std::clamp(share, 0.0f, 1.0f) * float{CompactHit::kSteps}));
}

}  // namespace

CompactHit CompactHit::from(const SurfacePoint& place) {
  const int u = toSteps(place.u);
  return {place.triangle, static_cast<std::uint16_t>(u),
          static_cast<std::uint16_t>(std::min(toSteps(place.v), kSteps - u))};
}

CompactAlbedo CompactAlbedo::from(Vec3f albedo) {
  return {static_cast<std::uint16_t>(toSteps(albedo.x)), static_cast<std::uint16_t>(toSteps(albedo.y)),
          static_cast<std::uint16_t>(toSteps(albedo.z))};
}

Vec3f CompactAlbedo::toFloat() const {
  constexpr float kSteps = CompactHit::kSteps;
  return {static_cast<float>(red) / kSteps, static_cast<float>(green) / kSteps,
          static_cast<float>(blue) / kSteps};
}

void HitStore::keep(std::size_t block, const BlockHits& hits) {
  const std::uint64_t bytes = hits.bytes();
  if (bytes_.fetch_add(bytes) + bytes > memory_) {
    bytes_ -= bytes;
    return;
  }
  blocks_[block] = hits;
}

}  // namespace shprt
