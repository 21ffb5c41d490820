// The order of a set's directions: neighbours in the same group, so that packets of rays stay together.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace shprt {

// Of the unit disc, where a cosine-distributed direction lies at equal area.
struct DiscPoint {
  double x, y;
};

// A permutation of the points' indices in which every run of `groupSize` is compact: the disc is halved at
// multiples of the group size across its longer side, until groups remain.
std::vector<int> orderByNeighbours(std::span<const DiscPoint> points, int groupSize);

// count rounded up to whole groups.
constexpr std::size_t wholeGroups(int count, int groupSize) {
  const auto size = static_cast<std::size_t>(groupSize);
  return (static_cast<std::size_t>(count) + size - 1) / size * size;
}

}  // namespace shprt
