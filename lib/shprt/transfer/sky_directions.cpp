#include "shprt/transfer/sky_directions.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "shprt/sampling/random.h"
#include "shprt/scene/ray_caster.h"

namespace shprt {

SkyDirections::SkyDirections(const Sky& sky, int cosineCount, int skyCount)
    : sky_(sky),
      cosine_(makeHemisphereSet(PointSet::kLattice, cosineCount, kRayPacketSize)),
      cosineCount_(static_cast<std::size_t>(cosineCount)) {
  assert(cosineCount >= 1 && skyCount >= 0);
  const auto cosineParts = cosine_->sixteenths();
  sixteenths_.assign(cosineParts.begin(), cosineParts.end());
  for (int i = 0; i < skyCount; ++i) sixteenths_.push_back(sixteenthInTurn(static_cast<std::size_t>(i)));
  for (const std::uint8_t part : sixteenths_) quarters_.push_back(part / 4);
  paddedCount_ = (quarters_.size() + kRayPacketSize - 1) / kRayPacketSize * kRayPacketSize;
}

void SkyDirections::directions(Vec3d normal, std::uint64_t seed, std::uint64_t index, float* x, float* y,
                               float* z) const {
  cosine_->directions(normal, seed, index, x, y, z);
  const std::size_t skyCount = quarters_.size() - cosineCount_;
  const double shift = uniformRandom(~seed, index, 0), turn = uniformRandom(~seed, index, 1);
  for (std::size_t i = 0; i < skyCount; ++i) {
    const std::size_t ray = cosineCount_ + i;
    const double turns = static_cast<double>(i) / std::numbers::phi + turn;
    const Vec3d direction = sky_.sample(turns - std::floor(turns),
                                        (static_cast<double>(i) + shift) / static_cast<double>(skyCount));
    const bool above = dot(direction, normal) > 0;
    const Vec3f rounded = toFloat(direction);
    x[ray] = above ? rounded.x : x[0];
    y[ray] = above ? rounded.y : y[0];
    z[ray] = above ? rounded.z : z[0];
  }
  for (std::size_t ray = quarters_.size(); ray < paddedCount_; ++ray) {
    x[ray] = x[quarters_.size() - 1];
    y[ray] = y[quarters_.size() - 1];
    z[ray] = z[quarters_.size() - 1];
  }
}

// Radiance times the cosine's density, over the sum of both kinds' densities and counts.
Vec3d SkyDirections::weighedRadiance(Vec3d direction, Vec3d normal) const {
  const double cosine = std::max(0.0, dot(direction, normal)) / std::numbers::pi;
  if (cosine == 0) return {};
  const auto skyCount = static_cast<double>(quarters_.size() - cosineCount_);
  const double skyDensity = skyCount > 0 ? skyCount * sky_.density(direction) : 0;
  return sky_.radiance(direction) * (cosine / (static_cast<double>(cosineCount_) * cosine + skyDensity));
}

}  // namespace shprt
