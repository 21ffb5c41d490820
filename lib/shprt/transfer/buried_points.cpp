#include "shprt/transfer/buried_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace shprt {
namespace {

constexpr float kSettled = 1e-3f;
constexpr int kMaximumSweeps = 64;

// Edges from buried points to their neighbours, each once, in increasing order.
std::vector<std::pair<std::uint32_t, std::uint32_t>> edgesOfBuried(const SurfaceTopology& topology,
                                                                   std::span<const std::uint8_t> isBuried) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& triangle : topology.triangles())
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t point = topology.pointIds()[triangle[k]];
      if (!isBuried[point]) continue;
      for (const std::size_t next : {(k + 1) % 3, (k + 2) % 3}) {
        const std::uint32_t neighbour = topology.pointIds()[triangle[next]];
        if (neighbour != point) edges.emplace_back(point, neighbour);
      }
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace

BuriedPoints::BuriedPoints(const SurfaceTopology& topology, std::span<const std::uint8_t> isBuried) {
  const auto edges = edgesOfBuried(topology, isBuried);
  const auto edgesOf = [&](std::uint32_t point) {
    const auto first = std::lower_bound(edges.begin(), edges.end(), std::pair(point, std::uint32_t{0}));
    auto last = first;
    while (last != edges.end() && last->first == point) ++last;
    return std::span(first, last);
  };

  // Layer by layer from the surface that is not buried.
  constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> layers(isBuried.size());
  for (std::size_t point = 0; point < layers.size(); ++point)
    layers[point] = isBuried[point] ? kUnreached : 0;
  std::vector<std::uint32_t> reached;
  for (const auto& [point, neighbour] : edges)
    if (!isBuried[neighbour] && layers[point] == kUnreached) {
      layers[point] = 1;
      reached.push_back(point);
    }
  for (std::size_t next = 0; next < reached.size(); ++next)
    for (const auto& [point, neighbour] : edgesOf(reached[next]))
      if (layers[neighbour] == kUnreached) {
        layers[neighbour] = layers[point] + 1;
        reached.push_back(neighbour);
      }

  for (const std::uint32_t point : reached) {
    Filled filled{point, neighbours_.size(), 0, 0};
    for (const auto& edge : edgesOf(point)) neighbours_.push_back(edge.second);
    filled.end = neighbours_.size();
    filled.settledEnd = static_cast<std::size_t>(
        std::stable_partition(neighbours_.begin() + static_cast<std::ptrdiff_t>(filled.firstNeighbour),
                              neighbours_.end(),
                              [&](std::uint32_t neighbour) { return layers[neighbour] < layers[point]; }) -
        neighbours_.begin());
    order_.push_back(filled);
  }
}

std::vector<std::uint32_t> BuriedPoints::renumber() {
  std::vector<std::uint32_t> points = neighbours_;
  for (const Filled& filled : order_) points.push_back(filled.point);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto rowOf = [&](std::uint32_t point) {
    return static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), point) - points.begin());
  };
  for (std::uint32_t& neighbour : neighbours_) neighbour = rowOf(neighbour);
  for (Filled& filled : order_) filled.point = rowOf(filled.point);
  return points;
}

// The row becomes the mean of its neighbours before `end`. Returns the largest change.
float BuriedPoints::average(LightRows& rows, const Filled& filled, std::size_t end,
                            std::vector<double>& sums) const {
  std::fill(sums.begin(), sums.end(), 0.0);
  for (std::size_t i = filled.firstNeighbour; i < end; ++i) {
    const float* neighbour = rows.row(neighbours_[i]);
    for (std::size_t column = 0; column < sums.size(); ++column)
      sums[column] += static_cast<double>(neighbour[column]);
  }
  float* row = rows.row(filled.point);
  float change = 0;
  for (std::size_t column = 0; column < sums.size(); ++column) {
    const float mean = static_cast<float>(sums[column] / static_cast<double>(end - filled.firstNeighbour));
    change = std::max(change, std::abs(mean - row[column]));
    row[column] = mean;
  }
  return change;
}

void BuriedPoints::fill(LightRows& rows) const {
  std::vector<double> sums(rows.stride());
  float largest = 0;
  for (const Filled& filled : order_) {
    average(rows, filled, filled.settledEnd, sums);
    const float* row = rows.row(filled.point);
    for (std::size_t column = 0; column < sums.size(); ++column)
      largest = std::max(largest, std::abs(row[column]));
  }
  for (int sweep = 0; sweep < kMaximumSweeps; ++sweep) {
    float change = 0;
    for (const Filled& filled : order_) change = std::max(change, average(rows, filled, filled.end, sums));
    if (change <= kSettled * largest) return;
  }
}

}  // namespace shprt
