#include "shprt/sampling/sobol_hemisphere.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "shprt/sampling/hemisphere.h"
#include "shprt/sampling/neighbour_order.h"
#include "shprt/sampling/random.h"

namespace shprt {
namespace {

// The path of halvings that leads to a cell: two across the azimuth, which is the longer way round, and then
// in turn.
std::uint64_t cellPath(std::uint32_t u, std::uint32_t v, int bits) {
  std::uint64_t path = v >> std::max(bits - 2, 0);
  for (int level = 0; level < bits; ++level) {
    path = path * 2 + ((u >> (bits - 1 - level)) & 1u);
    if (level + 2 < bits) path = path * 2 + ((v >> (bits - 3 - level)) & 1u);
  }
  return path;
}

}  // namespace

SobolHemisphere::SobolHemisphere(int count, int groupSize)
    : sequence_(count), paddedCount_(wholeGroups(count, groupSize)) {
  assert(groupSize >= 1);
  order_.resize(static_cast<std::size_t>(count));
  std::iota(order_.begin(), order_.end(), 0u);
  const auto path = [&](std::uint32_t i) {
    return cellPath(sequence_.cellU(i), sequence_.cellV(i), sequence_.bits());
  };
  std::sort(order_.begin(), order_.end(),
            [&](std::uint32_t a, std::uint32_t b) { return path(a) < path(b); });
  for (const std::uint32_t i : order_) {
    sixteenths_.push_back(static_cast<std::uint8_t>(std::uint64_t{16} * i / order_.size()));
    quarters_.push_back(sixteenths_.back() / 4);
  }
}

void SobolHemisphere::directions(Vec3d normal, std::uint64_t seed, std::uint64_t index, float* x, float* y,
                                 float* z) const {
  std::vector<SquarePoint> points;
  sequence_.scramble(hashCounter(seed, index), points);
  const Frame frame = frameFromNormal(normal);
  for (std::size_t slot = 0; slot < paddedCount_; ++slot) {
    const SquarePoint p = points[order_[std::min(slot, order_.size() - 1)]];
    const Vec3f direction = cosineDirectionAround(frame, p.u, p.v);
    x[slot] = direction.x, y[slot] = direction.y, z[slot] = direction.z;
  }
}

}  // namespace shprt
