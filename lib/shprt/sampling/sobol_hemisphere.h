// Cosine-distributed directions from the Owen-scrambled Sobol sequence (scrambled_sobol.h), scrambled anew
// for each vertex and mapped by sampleCosineHemisphere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/sampling/hemisphere_set.h"
#include "shprt/sampling/scrambled_sobol.h"

namespace shprt {

class SobolHemisphere final : public HemisphereSet {
 public:
  // The first `count` >= 1 points of the sequence. Scrambling keeps points that share a dyadic cell together,
  // so each group of `groupSize` takes such cells.
  SobolHemisphere(int count, int groupSize);

  std::size_t paddedCount() const override { return paddedCount_; }
  void directions(Vec3d normal, std::uint64_t seed, std::uint64_t index, float* x, float* y,
                  float* z) const override;
  // Runs of a quarter of the sequence; where count is a power of two, each is a (0,2)-net.
  std::span<const std::uint8_t> quarters() const override { return quarters_; }
  std::span<const std::uint8_t> sixteenths() const override { return sixteenths_; }

 private:
  ScrambledSobol sequence_;
  std::size_t paddedCount_;
  std::vector<std::uint32_t> order_;  // index in the sequence of each direction
  std::vector<std::uint8_t> quarters_, sixteenths_;
};

}  // namespace shprt
