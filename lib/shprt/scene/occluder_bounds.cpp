#include "shprt/scene/occluder_bounds.h"

#include <algorithm>

#include "shprt/scene/point_triangle_distance.h"

namespace shprt {
namespace {

using Lanes = OccluderTree::Lanes;
using Masks = OccluderTree::Masks;

// What heights in float may be off by, relative to the offset from the point to the far side of a box.
constexpr float kHeightRounding = 1e-6f;

Lanes magnitude(Lanes v) {
  return v < 0 ? -v : v;
}
Lanes larger(Lanes a, Lanes b) {
  return a > b ? a : b;
}

// The nodes of which a corner may be too high.
std::uint32_t nodesAbove(const OccluderTree::Group& group, Vec3f position, Vec3f normal) {
  const Lanes x = group.center.x - position.x, y = group.center.y - position.y,
              z = group.center.z - position.z;
  const Lanes height = normal.x * x + normal.y * y + normal.z * z + reach(group, normal);
  const Lanes farX = magnitude(x) + group.half.x, farY = magnitude(y) + group.half.y,
              farZ = magnitude(z) + group.half.z;
  // At least so far away along one axis.
  const Lanes apart =
      larger(larger(farX - 2 * group.half.x, farY - 2 * group.half.y), farZ - 2 * group.half.z);
  const Masks above = height + kHeightRounding * (farX + farY + farZ) >
                      static_cast<float>(kFlatElevation) * larger(apart, Lanes{});
  std::uint32_t mask = 0;
  for (std::size_t lane = 0; lane < OccluderTree::kWidth; ++lane) mask |= (above[lane] & 1u) << lane;
  return mask;
}

bool isIgnored(const IgnoredTriangles& ignored, std::uint32_t triangle) {
  return std::binary_search(ignored.meeting.begin(), ignored.meeting.end(), triangle) ||
         std::binary_search(ignored.touching.begin(), ignored.touching.end(), triangle);
}

}  // namespace

bool OccluderBounds::anythingAbove(Vec3f position, Vec3d normal, const IgnoredTriangles& ignored,
                                   Hint& hint) const {
  const Vec3d here = toDouble(position);
  const auto rises = [&](std::size_t slot) {
    const OccluderTree::Corners corners = tree_.corners(slot);
    const Vec3d a = toDouble(corners.a) - here, b = toDouble(corners.b) - here,
                c = toDouble(corners.c) - here;
    const double height = std::max({dot(normal, a), dot(normal, b), dot(normal, c)});
    if (height <= 0 || isIgnored(ignored, tree_.triangle(slot))) return false;
    return height > kFlatElevation * pointTriangleDistance({}, a, b, c);
  };
  if (hint < tree_.triangleCount() && rises(hint)) return true;
  const Vec3f normalFloat = toFloat(normal);
  return tree_.walk(
      [&](const OccluderTree::Group& group) { return nodesAbove(group, position, normalFloat); },
      [&](std::size_t slot) {
        if (!rises(slot)) return false;
        hint = static_cast<Hint>(slot);
        return true;
      });
}

}  // namespace shprt
