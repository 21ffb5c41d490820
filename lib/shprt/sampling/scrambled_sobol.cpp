#include "shprt/sampling/scrambled_sobol.h"

#include <bit>
#include <cassert>

namespace shprt {
namespace {

// Where the coins of `key` send each number of `bits` bits.
std::vector<std::uint32_t> nestedPermutation(std::uint64_t key, int bits) {
  std::vector<std::uint32_t> image(std::size_t{1} << bits);
  std::uint64_t coins = hashCounter(key, 0);
  for (int level = 0; level < bits; ++level) {
    // From the images of prefixes to those of prefixes one bit longer, in place, the last first.
    const std::uint32_t nodes = 1u << level;
    for (std::uint32_t prefix = nodes; prefix-- > 0;) {
      const std::uint32_t node = nodes + prefix;
      if (node >= 64 && node % 64 == 63) coins = hashCounter(key, node / 64);
      const std::uint32_t swapped = (coins >> (node % 64)) & 1u;
      const std::uint32_t parent = 2 * image[prefix];
      image[2 * prefix] = parent | swapped;
      image[2 * prefix + 1] = parent | (swapped ^ 1u);
    }
  }
  return image;
}

}  // namespace

ScrambledSobol::ScrambledSobol(int count)
    : count_(count), bits_(static_cast<int>(std::bit_width(static_cast<std::uint32_t>(count) - 1))) {
  assert(count >= 1 && bits_ < 31);
}

std::uint32_t ScrambledSobol::cellU(std::uint32_t i) const {
  // Generator matrix: the identity, which mirrors the index at the binary point.
  std::uint32_t cell = 0;
  for (int bit = 0; bit < bits_; ++bit) cell |= ((i >> bit) & 1u) << (bits_ - 1 - bit);
  return cell;
}

std::uint32_t ScrambledSobol::cellV(std::uint32_t i) const {
  // Generator matrix: Pascal's triangle modulo 2, whose columns follow each other by c ^ (c >> 1).
  std::uint32_t cell = 0;
  std::uint32_t column = (1u << bits_) >> 1;
  for (; i != 0; i >>= 1, column ^= column >> 1)
    if (i & 1u) cell ^= column;
  return cell;
}

void ScrambledSobol::scramble(std::uint64_t key, std::vector<SquarePoint>& points) const {
  const std::vector<std::uint32_t> imageU = nestedPermutation(hashCounter(key, 0), bits_);
  const std::vector<std::uint32_t> imageV = nestedPermutation(hashCounter(key, 1), bits_);
  const std::uint64_t keyBelow = hashCounter(key, 2);
  const double cellSize = 1.0 / static_cast<double>(imageU.size());
  points.resize(static_cast<std::size_t>(count_));
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const SquarePoint below = randomPoint(keyBelow, i);
    points[i] = {(imageU[cellU(i)] + below.u) * cellSize, (imageV[cellV(i)] + below.v) * cellSize};
  }
}

}  // namespace shprt
