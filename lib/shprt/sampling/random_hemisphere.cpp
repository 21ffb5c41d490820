#include "shprt/sampling/random_hemisphere.h"

#include <algorithm>
#include <cassert>

#include "shprt/sampling/hemisphere.h"
#include "shprt/sampling/neighbour_order.h"
#include "shprt/sampling/random.h"

namespace shprt {

RandomHemisphere::RandomHemisphere(int count, int groupSize) : paddedCount_(wholeGroups(count, groupSize)) {
  assert(count >= 1 && groupSize >= 1);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    quarters_.push_back(quarterInTurn(i));
    sixteenths_.push_back(sixteenthInTurn(i));
  }
}

void RandomHemisphere::directions(Vec3d normal, std::uint64_t seed, std::uint64_t index, float* x, float* y,
                                  float* z) const {
  const std::uint64_t key = hashCounter(seed, index);
  const Frame frame = frameFromNormal(normal);
  for (std::size_t slot = 0; slot < paddedCount_; ++slot) {
    const SquarePoint p = randomPoint(key, std::min(slot, quarters_.size() - 1));
    const Vec3f direction = cosineDirectionAround(frame, p.u, p.v);
    x[slot] = direction.x, y[slot] = direction.y, z[slot] = direction.z;
  }
}

}  // namespace shprt
