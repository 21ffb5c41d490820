#include "shprt/mesh/corner_normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "shprt/mesh/triangulate.h"

namespace shprt {
namespace {

// Disjoint sets of corners; the representative is the lowest corner, so results do not depend on the order of
// joins.
class CornerSets {
 public:
  explicit CornerSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    if (a < b)
      parent_[b] = a;
    else
      parent_[a] = b;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// A directed edge of a triangle: from the position of `corner` to that of its next corner.
struct Edge {
  std::uint32_t low, high, corner;
  friend bool operator<(const Edge& a, const Edge& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.corner < b.corner;
  }
};

std::uint32_t nextCorner(std::uint32_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

}  // namespace

std::vector<Vec3f> computeCornerNormals(std::span<const Vec3f> positions, std::span<const Triangle> triangles,
                                        double creaseAngleDegrees) {
  const std::size_t cornerCount = 3 * triangles.size();
  const auto positionOf = [&](std::size_t corner) { return triangles[corner / 3][corner % 3]; };
  std::vector<Vec3d> faceNormals(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    faceNormals[t] =
        normalize(areaDirection(toDouble(positions[a]), toDouble(positions[b]), toDouble(positions[c])));
  }

  std::vector<Edge> edges;
  edges.reserve(cornerCount);
  for (std::uint32_t corner = 0; corner < cornerCount; ++corner) {
    const auto [low, high] = std::minmax({positionOf(corner), positionOf(nextCorner(corner))});
    edges.push_back({low, high, corner});
  }
  std::sort(edges.begin(), edges.end());
  CornerSets sets(cornerCount);
  const double leastCosine = std::cos(std::clamp(creaseAngleDegrees, 0.0, 180.0) * std::numbers::pi / 180);
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high)
      ++end;
    const std::uint32_t a = edges[begin].corner, b = edges[end - 1].corner;
    const bool pair = end - begin == 2 && positionOf(a) == positionOf(nextCorner(b)) &&
                      positionOf(b) == positionOf(nextCorner(a));
    if (pair && dot(faceNormals[a / 3], faceNormals[b / 3]) >= leastCosine - 1e-9) {
      sets.join(a, nextCorner(b));
      sets.join(b, nextCorner(a));
    }
    begin = end;
  }

  std::vector<Vec3d> sums(cornerCount);
  for (std::uint32_t corner = 0; corner < cornerCount; ++corner) {
    const Vec3d here = toDouble(positions[positionOf(corner)]);
    const Vec3d next = normalize(toDouble(positions[positionOf(nextCorner(corner))]) - here);
    const Vec3d previous = normalize(toDouble(positions[positionOf(nextCorner(nextCorner(corner)))]) - here);
    const double angle = std::atan2(length(cross(next, previous)), dot(next, previous));
    sums[sets.find(corner)] += faceNormals[corner / 3] * angle;
  }
  std::vector<Vec3f> normals(cornerCount);
  for (std::uint32_t corner = 0; corner < cornerCount; ++corner) {
    const Vec3d sum = sums[sets.find(corner)];
    // A fan that folds back on itself has no mean direction; each of its faces then keeps its own.
    normals[corner] = toFloat(length(sum) > 1e-9 ? normalize(sum) : faceNormals[corner / 3]);
  }
  return normals;
}

}  // namespace shprt
