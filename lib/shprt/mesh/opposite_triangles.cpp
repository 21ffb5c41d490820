#include "shprt/mesh/opposite_triangles.h"

#include <algorithm>
#include <array>

#include "shprt/mesh/distinct.h"
#include "shprt/mesh/position_ids.h"

namespace shprt {

std::vector<std::uint32_t> oppositeTriangles(const Mesh& mesh) {
  const std::vector<std::uint32_t> positionIds = distinctPositionIds(mesh.positions);
  const auto corners = [&](std::size_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return std::array{positionIds[a], positionIds[b], positionIds[c]};
  };
  // Whether sorting the corners turns the triangle over.
  const auto isOdd = [&](std::size_t triangle) {
    const auto [a, b, c] = corners(triangle);
    return ((a > b) != (b > c)) != (a > c);
  };
  const std::vector<std::uint32_t> groups =
      numberDistinct<3>(mesh.triangles.size(), [&](std::size_t triangle) {
        auto sorted = corners(triangle);
        std::sort(sorted.begin(), sorted.end());
        return sorted;
      }).ids;
  std::vector<std::array<std::uint32_t, 2>> firstOfGroup(groups.size(), {kNoTriangle, kNoTriangle});
  for (std::size_t i = groups.size(); i-- > 0;) {
    firstOfGroup[groups[i]][isOdd(i)] = static_cast<std::uint32_t>(i);
  }
  std::vector<std::uint32_t> opposite(groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i) opposite[i] = firstOfGroup[groups[i]][!isOdd(i)];
  return opposite;
}

}  // namespace shprt
