// Directions for gathering light at a point: some that follow the cosine, some that follow the sky, weighed
// so that each kind counts where it is the better of the two.
//
// Based on: Veach and Guibas 1995 (multiple importance sampling, the balance heuristic).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "shprt/sampling/hemisphere_set.h"
#include "shprt/transfer/sky_sampler.h"

namespace shprt {

// First `cosineCount` cosine-distributed directions of the shifted lattice that bakes use, then `skyCount`
// drawn from the sky at a lattice of its own. Those of them that lie below the horizon repeat direction 0.
class SkyDirections final : public HemisphereSet {
 public:
  // The sky must outlive it. cosineCount >= 1; groups are packets of kRayPacketSize.
  SkyDirections(const Sky& sky, int cosineCount, int skyCount);

  std::size_t paddedCount() const override { return paddedCount_; }
  void directions(Vec3d normal, std::uint64_t seed, std::uint64_t index, float* x, float* y,
                  float* z) const override;
  std::span<const std::uint8_t> quarters() const override { return quarters_; }
  std::span<const std::uint8_t> sixteenths() const override { return sixteenths_; }

  std::size_t cosineCount() const { return cosineCount_; }

  // Estimates the mean over cosine-distributed directions of sky radiance times visibility. `rays` holds the
  // directions around the unit normal, as x(), y(), z(), and which of them see the sky, as seesSky(ray).
  template <typename Rays>
  Vec3d skyLight(const Rays& rays, Vec3d normal) const {
    Vec3d sum;
    for (std::size_t ray = 0; ray < quarters_.size(); ++ray)
      if (rays.seesSky(ray) && !isRepeat(ray, rays.x(), rays.y(), rays.z()))
        sum += weighedRadiance({rays.x()[ray], rays.y()[ray], rays.z()[ray]}, normal);
    return sum;
  }

 private:
  bool isRepeat(std::size_t ray, const float* x, const float* y, const float* z) const {
    return ray >= cosineCount_ && x[ray] == x[0] && y[ray] == y[0] && z[ray] == z[0];
  }
  Vec3d weighedRadiance(Vec3d direction, Vec3d normal) const;

  const Sky& sky_;
  std::unique_ptr<HemisphereSet> cosine_;
  std::size_t cosineCount_, paddedCount_;
  std::vector<std::uint8_t> quarters_, sixteenths_;
};

}  // namespace shprt
