// A hierarchy of bounds over triangles, for deciding what may rise above a plane.
//
// Triangles lie in Morton order, four to a leaf, and four nodes to a group on every level: where anything is
// follows from its number, so nothing points anywhere. A node is bounded by an axis-parallel box and by a
// slab across the mean normal of its triangles. The slab is what tells that a flat or gently curved piece of
// surface, in whatever direction, does not reach above the tangent plane of its neighbour; boxes alone would
// have to be opened down to single triangles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

class OccluderTree {
 public:
  static constexpr std::size_t kWidth = 4;
  // The compiler's vectors, one lane per node of a group: the width that every processor has registers for.
  using Lanes = float __attribute__((vector_size(sizeof(float) * kWidth)));
  using Masks = std::int32_t __attribute__((vector_size(sizeof(std::int32_t) * kWidth)));

  struct Lanes3 {
    Lanes x, y, z;
  };
  // Every point q below a node has |q - center| <= half on each axis, and |axis . (q - center) - offset| <=
  // thickness, with axis a unit vector or zero.
  struct Group {
    Lanes3 center, half, axis;
    Lanes offset, thickness;
  };
  struct Corners {
    Vec3f a, b, c;
  };

  // Coordinates near the origin and of order one (scene_frame.h), at least one triangle. The arrays must
  // outlive the tree.
  OccluderTree(std::span<const Vec3f> positions, std::span<const std::array<std::uint32_t, 3>> triangles);

  std::size_t triangleCount() const { return triangles_.size(); }
  // Triangles are numbered in the tree's own order; this is the number of one in the array given.
  std::uint32_t triangle(std::size_t slot) const { return triangles_[slot]; }
  Corners corners(std::size_t slot) const {
    const auto& [a, b, c] = meshTriangles_[triangles_[slot]];
    return {positions_[a], positions_[b], positions_[c]};
  }

  // Walks the tree from the top. open(group) returns a bit per node of a group that is to be opened; at the
  // bottom, visit(slot) is called for each triangle of such a node and ends the walk by returning true.
  // Returns whether it did.
  template <typename Open, typename Visit>
  bool walk(const Open& open, const Visit& visit) const;

 private:
  struct Level {
    std::size_t first;  // its first group
    std::size_t nodes;
  };

  std::span<const Vec3f> positions_;
  std::span<const std::array<std::uint32_t, 3>> meshTriangles_;
  std::vector<std::uint32_t> triangles_;  // in the tree's order
  std::vector<Group> groups_;
  std::vector<Level> levels_;  // from the leaves up; the last has one group
};

// How much farther than their centers nodes reach along a unit direction n, at most.
inline OccluderTree::Lanes reach(const OccluderTree::Group& group, Vec3f n) {
  using Lanes = OccluderTree::Lanes;
  const auto magnitude = [](Lanes v) { return v < 0 ? -v : v; };
  const Lanes box =
      std::fabs(n.x) * group.half.x + std::fabs(n.y) * group.half.y + std::fabs(n.z) * group.half.z;
  // n = k axis + rest: the slab bounds the first part, the box the second.
  const Lanes k = n.x * group.axis.x + n.y * group.axis.y + n.z * group.axis.z;
  const Lanes slab =
      k * group.offset + magnitude(k) * group.thickness + magnitude(n.x - k * group.axis.x) * group.half.x +
      magnitude(n.y - k * group.axis.y) * group.half.y + magnitude(n.z - k * group.axis.z) * group.half.z;
  return slab < box ? slab : box;
}

template <typename Open, typename Visit>
bool OccluderTree::walk(const Open& open, const Visit& visit) const {
  struct Entry {
    std::uint32_t level, group;
  };
  // Four nodes wide and below 2^32 triangles: at most 16 levels, each of which leaves three entries behind.
  Entry stack[64];
  std::size_t size = 0;
  stack[size++] = {static_cast<std::uint32_t>(levels_.size() - 1), 0};
  while (size > 0) {
    const Entry entry = stack[--size];
    const Level& level = levels_[entry.level];
    const std::size_t firstNode = std::size_t{entry.group} * kWidth;
    std::uint32_t opened = open(groups_[level.first + entry.group]);
    for (; opened != 0; opened &= opened - 1) {
      const std::size_t node = firstNode + static_cast<std::size_t>(__builtin_ctz(opened));
      if (node >= level.nodes) break;
      if (entry.level > 0) {
        stack[size++] = {entry.level - 1, static_cast<std::uint32_t>(node)};
        continue;
      }
      const std::size_t end = std::min(triangles_.size(), (node + 1) * kWidth);
      for (std::size_t slot = node * kWidth; slot < end; ++slot)
        if (visit(slot)) return true;
    }
  }
  return false;
}

}  // namespace shprt
