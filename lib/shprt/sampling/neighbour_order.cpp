#include "shprt/sampling/neighbour_order.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace shprt {
namespace {

void halve(std::span<const DiscPoint> points, std::span<int> order, std::size_t groupSize) {
  if (order.size() <= groupSize) return;
  const auto x = [&](int i) { return points[static_cast<std::size_t>(i)].x; };
  const auto y = [&](int i) { return points[static_cast<std::size_t>(i)].y; };
  const auto extent = [&](const auto& coordinate) {
    const auto [low, high] = std::minmax_element(order.begin(), order.end(),
                                                 [&](int a, int b) { return coordinate(a) < coordinate(b); });
    return coordinate(*high) - coordinate(*low);
  };
  const bool splitX = extent(x) > extent(y);
  const std::size_t groups = (order.size() + groupSize - 1) / groupSize;
  const std::size_t half = (groups / 2) * groupSize;
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(half), order.end(),
                   [&](int a, int b) {
                     const double keyA = splitX ? x(a) : y(a), keyB = splitX ? x(b) : y(b);
                     return keyA != keyB ? keyA < keyB : a < b;
                   });
  halve(points, order.first(half), groupSize);
  halve(points, order.subspan(half), groupSize);
}

}  // namespace

std::vector<int> orderByNeighbours(std::span<const DiscPoint> points, int groupSize) {
  assert(groupSize >= 1);
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  halve(points, order, static_cast<std::size_t>(groupSize));
  return order;
}

}  // namespace shprt
