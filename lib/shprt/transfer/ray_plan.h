// How many rays each point of a bake takes, and the sets of directions for them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "shprt/sampling/hemisphere_set.h"

namespace shprt {

class RayPlan {
 public:
  // Levels double: level k has kLeastRays << k rays.
  static constexpr int kLeastRays = 32;
  static constexpr int kLevels = 12;  // to 65,536
  static constexpr int raysOfLevel(int level) { return kLeastRays << level; }

  // The same number for every point.
  RayPlan(PointSet points, int rays);
  // The same set for every point; it must outlive the plan.
  explicit RayPlan(const HemisphereSet& set) : same_(&set) {}
  // A level in [0, kLevels) for each point.
  RayPlan(PointSet points, std::vector<std::uint8_t> levels);

  const HemisphereSet& set(std::size_t point) const {
    return levels_.empty() ? *same_ : *sets_[levels_[point]];
  }
  int rays(std::size_t point) const { return set(point).count(); }

 private:
  const HemisphereSet* same_ = nullptr;               // where there are no levels
  std::vector<std::unique_ptr<HemisphereSet>> sets_;  // by level; null where no point asks for it
  std::vector<std::uint8_t> levels_;
};

}  // namespace shprt
