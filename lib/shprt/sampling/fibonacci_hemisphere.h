// Cosine-distributed directions from a Fibonacci lattice with a random shift for every vertex: the set with
// the least error among those measured (docs/accuracy.md).
//
// Point i of n is u = (i + s) / n, v = i / golden ratio + t (mod 1), with s and t uniform in [0,1) and drawn
// anew for each vertex. Each point is uniform over its stratum, so every estimate is unbiased. Because s
// moves a point only within its ring and t turns them all together, azimuths can be tabulated and t folded
// into the tangent frame: a direction costs two square roots and no trigonometry.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/sampling/hemisphere_set.h"

namespace shprt {

class FibonacciHemisphere final : public HemisphereSet {
 public:
  // count >= 1 points. Their order is a permutation of the lattice that puts neighbours of the disc into the
  // same group of `groupSize` points, so that packets of rays stay together.
  FibonacciHemisphere(int count, int groupSize);

  std::size_t paddedCount() const override { return cosines_.size(); }
  void directions(Vec3d normal, std::uint64_t seed, std::uint64_t index, float* x, float* y,
                  float* z) const override;
  // Halves by the parity of i; quarters by that of i and of the whole turns in i / golden ratio. Those of a
  // quarter make the same lattice stretched by two, both ways, but for a seam along one radius.
  std::span<const std::uint8_t> quarters() const override { return quarters_; }
  std::span<const std::uint8_t> sixteenths() const override { return sixteenths_; }

 private:
  std::vector<std::uint8_t> quarters_, sixteenths_;
  std::vector<float> cosines_, sines_;  // of the azimuth at t = 0
  std::vector<float> rings_;            // i / n
};

}  // namespace shprt
