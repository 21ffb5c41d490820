// Cosine-distributed directions, one at random in each of n cells of equal area (jittered, or stratified,
// sampling).
//
// The unit square (u, v) of sampleCosineHemisphere is cut into about sqrt(n) rows of u, and these into about
// sqrt(n) cells of v each. For any n: row r of a holds the k_r = floor((r+1) n/a) - floor(r n/a) cells from
// floor(r n/a) on; it is k_r/n high and its cells 1/k_r wide, so that each has the area 1/n and the mean over
// the directions is unbiased. For n = a^2 that is the square grid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/sampling/hemisphere_set.h"

namespace shprt {

class JitteredHemisphere final : public HemisphereSet {
 public:
  // count >= 1 cells; those that neighbour each other on the disc are in the same group of `groupSize`.
  JitteredHemisphere(int count, int groupSize);

  std::size_t paddedCount() const override { return cells_.size(); }
  void directions(Vec3d normal, std::uint64_t seed, std::uint64_t index, float* x, float* y,
                  float* z) const override;
  // Halves are the two colours of a chessboard, quarters the four places in blocks of two by two cells; as
  // near to it as rows of different length allow.
  std::span<const std::uint8_t> quarters() const override { return quarters_; }
  std::span<const std::uint8_t> sixteenths() const override { return sixteenths_; }

 private:
  struct Cell {
    double u, v;           // the corner next to the origin
    double height, width;  // along u, along v
  };
  std::vector<Cell> cells_;  // padded: the last repeats
  std::vector<std::uint8_t> quarters_, sixteenths_;
};

}  // namespace shprt
