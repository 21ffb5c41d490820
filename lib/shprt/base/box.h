// The smallest box along the axes that holds a set of positions.
#pragma once

#include <algorithm>
#include <cassert>
#include <span>

#include "shprt/base/vec.h"

namespace shprt {

struct Box {
  Vec3d low, high;

  // The largest side.
  double extent() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

// At least one position, all finite.
inline Box boxAround(std::span<const Vec3f> positions) {
  assert(!positions.empty());
  Vec3f low = positions[0], high = low;
  for (const Vec3f& p : positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {toDouble(low), toDouble(high)};
}

}  // namespace shprt
