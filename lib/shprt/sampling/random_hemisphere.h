// Independent cosine-distributed directions: what other sets are compared with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/sampling/hemisphere_set.h"

namespace shprt {

class RandomHemisphere final : public HemisphereSet {
 public:
  // count >= 1. The order means nothing: independent points have no lasting neighbours.
  RandomHemisphere(int count, int groupSize);

  std::size_t paddedCount() const override { return paddedCount_; }
  void directions(Vec3d normal, std::uint64_t seed, std::uint64_t index, float* x, float* y,
                  float* z) const override;
  // Dealt out in turn.
  std::span<const std::uint8_t> quarters() const override { return quarters_; }
  std::span<const std::uint8_t> sixteenths() const override { return sixteenths_; }

 private:
  std::size_t paddedCount_;
  std::vector<std::uint8_t> quarters_, sixteenths_;
};

}  // namespace shprt
