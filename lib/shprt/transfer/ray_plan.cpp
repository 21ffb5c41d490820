#include "shprt/transfer/ray_plan.h"

#include <cassert>
#include <utility>

#include "shprt/scene/ray_caster.h"

namespace shprt {

RayPlan::RayPlan(PointSet points, int rays) {
  sets_.push_back(makeHemisphereSet(points, rays, kRayPacketSize));
  same_ = sets_.front().get();
}

RayPlan::RayPlan(PointSet points, std::vector<std::uint8_t> levels)
    : sets_(kLevels), levels_(std::move(levels)) {
  assert(!levels_.empty());
  for (const std::uint8_t level : levels_) {
    assert(level < kLevels);
    if (!sets_[level]) sets_[level] = makeHemisphereSet(points, raysOfLevel(level), kRayPacketSize);
  }
}

}  // namespace shprt
