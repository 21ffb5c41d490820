// Polygons to triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

// The work that one mesh may cost, in tests of a corner against an ear: a few seconds.
struct TriangulationBudget {
  std::uint64_t testsLeft = 2'000'000'000;
};

// Cuts one polygon of n >= 3 corners into n - 2 triangles with its orientation, given as indices into
// `corners`. Works in the polygon's mean plane; concave polygons, collinear corners and bridges to holes come
// out right, self-crossing ones somehow. Results are appended. Convex polygons take O(n), others O(n r) for r
// reflex or collinear corners. Returns false when that would have taken too long (16 n^2 tests, or what is
// left of the budget, which is used up by what it takes) and the rest of the polygon was cut corner by corner
// as it came.
bool triangulate(std::span<const Vec3d> corners, std::vector<std::array<std::uint32_t, 3>>& triangles,
                 TriangulationBudget& budget);

// Twice the area vector of a triangle, computed from differences scaled so that it neither over- nor
// underflows: zero exactly when the corners are collinear to double rounding of float coordinates. Only its
// direction is meaningful.
Vec3d areaDirection(Vec3d a, Vec3d b, Vec3d c);

}  // namespace shprt
