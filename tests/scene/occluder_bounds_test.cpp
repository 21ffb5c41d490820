// What may stand above a tangent plane, against trying every triangle, and where geometry tells the answer.
#include "shprt/scene/occluder_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "shprt/scene/point_triangle_distance.h"
#include "shprt/scene/scene_frame.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// The definition, one triangle after another.
bool anythingAbove(const std::vector<Vec3f>& positions, const Triangles& triangles, Vec3f position,
                   Vec3d normal, const IgnoredTriangles& ignored) {
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (std::count(ignored.meeting.begin(), ignored.meeting.end(), t) ||
        std::count(ignored.touching.begin(), ignored.touching.end(), t))
      continue;
    Vec3d corner[3];
    double height = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = toDouble(positions[triangles[t][k]]) - toDouble(position);
      height = std::max(height, dot(normal, corner[k]));
    }
    if (height > kFlatElevation * pointTriangleDistance({}, corner[0], corner[1], corner[2])) return true;
  }
  return false;
}

// Triangles with a corner at the position of a vertex.
std::vector<std::uint32_t> trianglesAt(const std::vector<Vec3f>& positions, const Triangles& triangles,
                                       std::size_t vertex) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    if (std::any_of(triangles[t].begin(), triangles[t].end(),
                    [&](std::uint32_t corner) { return positions[corner] == positions[vertex]; }))
      found.push_back(t);
  return found;
}

// Per vertex, whether anything rises above its plane; the bounds and the definition must say the same.
std::vector<bool> verticesBelowSomething(const Mesh& mesh) {
  const std::vector<Vec3f> positions = toScene(chooseSceneFrame(mesh.positions), mesh.positions);
  const OccluderBounds bounds(positions, mesh.triangles);
  OccluderBounds::Hint hint = 0;
  std::vector<bool> below;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const std::vector<std::uint32_t> meeting = trianglesAt(positions, mesh.triangles, v);
    const IgnoredTriangles ignored{meeting, {}};
    const Vec3d normal = normalize(toDouble(mesh.normals[v]));
    below.push_back(bounds.anythingAbove(positions[v], normal, ignored, hint));
    EXPECT_EQ(below.back(), anythingAbove(positions, mesh.triangles, positions[v], normal, ignored))
        << "vertex " << v;
  }
  return below;
}

std::size_t count(const std::vector<bool>& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), true));
}

TEST(OccluderBounds, NothingStandsAboveConvexMeshesAtAnySizeAndPlace) {
  for (const double scale : {1e-30, 1e-4, 1.0, 1e30})
    for (const double away : {0.0, 1e4}) {
      const Vec3d offset = Vec3d{1, -0.5, 0.75} * (away * scale);
      EXPECT_EQ(count(verticesBelowSomething(
                    test::moved(test::makeBox({-1, -1, -1}, {2, 2, 2}, 4), scale, offset))),
                0u)
          << "box, " << scale << " " << away;
      EXPECT_EQ(
          count(verticesBelowSomething(test::moved(test::makeIcosphere(away > 0 ? 1 : 3), scale, offset))),
          0u)
          << "sphere, " << scale << " " << away;
    }
}

TEST(OccluderBounds, CreasesOfAConvexBodyAndFacesAskewAreFlat) {
  // A box turned so that no face lies along an axis: its faces are flat only to the rounding of floats.
  Mesh box = test::makeBox({-1, -1, -1}, {2, 2, 2}, 12);
  const Vec3d x = normalize(Vec3d{2, 1, -0.3}), y = normalize(cross(Vec3d{0.1, 0.4, 1}, x)), z = cross(x, y);
  const auto turned = [&](Vec3f v) {
    return toFloat(x * static_cast<double>(v.x) + y * static_cast<double>(v.y) +
                   z * static_cast<double>(v.z));
  };
  std::transform(box.positions.begin(), box.positions.end(), box.positions.begin(), turned);
  std::transform(box.normals.begin(), box.normals.end(), box.normals.begin(), turned);
  EXPECT_EQ(count(verticesBelowSomething(box)), 0u);
}

TEST(OccluderBounds, ConcaveCreaseIsFound) {
  // Two quads that meet at the z axis, the second one rising from the first.
  for (const double rise : {1e-3, 0.1, 1.0}) {
    Mesh mesh;
    test::addPatch(mesh, {-1, 0, 0}, {0, 0, 1}, {1, 0, 0}, 4);
    const std::size_t floor = mesh.positions.size();
    test::addPatch(mesh, {0, 0, 0}, {0, 0, 1}, {1, rise, 0}, 4);
    const std::vector<bool> below = verticesBelowSomething(mesh);
    for (std::size_t v = 0; v < floor; ++v) EXPECT_TRUE(below[v]) << rise << " " << v;
  }
}

TEST(OccluderBounds, SeparateBoxesSeeEachOtherAcrossTheGapOnly) {
  Mesh boxes = test::makeBox({-1, -1, -1}, {1, 2, 2}, 3);
  test::append(boxes, test::makeBox({2, -1, -1}, {1, 2, 2}, 3));
  const std::vector<bool> below = verticesBelowSomething(boxes);
  for (std::size_t v = 0; v < below.size(); ++v) {
    const bool facing = boxes.positions[v].x < 1 ? boxes.normals[v].x > 0.5f : boxes.normals[v].x < -0.5f;
    EXPECT_EQ(below[v], facing) << v;
  }
}

// A ball of radius 1 at height 2 above a floor: all of the floor lies below it; a point of the ball sees the
// floor's farthest corners above its plane, or not.
TEST(OccluderBounds, FloorUnderABall) {
  Mesh mesh;
  test::addPatch(mesh, {-3, 0, -3}, {0, 0, 6}, {6, 0, 0}, 6);
  const std::size_t floor = mesh.positions.size();
  test::append(mesh, test::moved(test::makeIcosphere(2), 1, {0, 2, 0}));
  const std::vector<bool> below = verticesBelowSomething(mesh);
  for (std::size_t v = 0; v < below.size(); ++v) {
    // The highest floor corner above the plane of n at p = (0, 2, 0) + n.
    const Vec3d n = toDouble(mesh.normals[v]);
    const double height = 3 * std::abs(n.x) + 3 * std::abs(n.z) - 2 * n.y - 1;
    if (v < floor) {
      EXPECT_TRUE(below[v]) << v;
    } else if (std::abs(height) > 1e-2) {
      EXPECT_EQ(below[v], height > 0) << v;
    }
  }
}

// A big flat triangle that passes just over the point, all of its corners at grazing elevation: corners alone
// would not tell.
TEST(OccluderBounds, CeilingWithFarCornersIsFound) {
  const std::vector<Vec3f> positions = {{-1, 1e-5f, -1}, {1, 1e-5f, -1}, {0, 1e-5f, 1}};
  const Triangles triangles = {{0, 1, 2}};
  const OccluderBounds bounds(positions, triangles);
  OccluderBounds::Hint hint = 0;
  EXPECT_TRUE(bounds.anythingAbove({0, 0, 0}, {0, 1, 0}, {}, hint));
  EXPECT_FALSE(bounds.anythingAbove({0, 0, 0}, {0, -1, 0}, {}, hint));
  const std::vector<std::uint32_t> all = {0};
  EXPECT_FALSE(bounds.anythingAbove({0, 0, 0}, {0, 1, 0}, {all, {}}, hint));
  EXPECT_FALSE(bounds.anythingAbove({0, 0, 0}, {0, 1, 0}, {{}, all}, hint));
}

// Neither a wrong no nor a wrong yes: the bounds only skip what the definition would reject. Triangles of all
// sizes and shapes, and planes through points of their hull, where the answer is close.
TEST(OccluderBounds, CloudOfTrianglesAgreesWithTryingEachOne) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  const auto direction = [&] {
    for (;;) {
      const Vec3d v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      if (const double r = length(v); r > 0.1 && r < 1) return v / r;
    }
  };
  std::size_t yes = 0, no = 0;
  for (const std::size_t triangleCount : {1u, 2u, 5u, 17u, 300u, 1500u}) {
    std::vector<Vec3f> positions;
    Triangles triangles;
    for (std::size_t t = 0; t < triangleCount; ++t) {
      const Vec3d middle = direction() * std::cbrt(uniform(0, 1));
      const double size = std::exp(uniform(-9, -1));
      for (int k = 0; k < 3; ++k) positions.push_back(toFloat(middle + direction() * size));
      const auto first = static_cast<std::uint32_t>(3 * t);
      triangles.push_back({first, first + 1, t % 50 == 49 ? first + 1 : first + 2});
    }
    const OccluderBounds bounds(positions, triangles);
    for (int query = 0; query < 500; ++query) {
      Vec3d normal = direction();
      const auto higher = [&](Vec3f a, Vec3f b) {
        return dot(normal, toDouble(a)) < dot(normal, toDouble(b));
      };
      // The highest corner along the normal, moved by little or nothing, in or out.
      const Vec3f top = *std::max_element(positions.begin(), positions.end(), higher);
      const double shift = query % 3 == 0 ? 0 : std::exp(uniform(-16, 0)) * (query % 3 == 1 ? -1 : 1);
      const Vec3f position = toFloat(toDouble(top) + normal * shift + direction() * (shift * 0.5));
      const std::vector<std::uint32_t> meeting = trianglesAt(
          positions, triangles,
          static_cast<std::size_t>(std::find(positions.begin(), positions.end(), top) - positions.begin()));
      IgnoredTriangles ignored;
      if (query % 2) ignored.meeting = meeting;
      OccluderBounds::Hint hint = static_cast<OccluderBounds::Hint>(random());
      const bool above = bounds.anythingAbove(position, normal, ignored, hint);
      ASSERT_EQ(above, anythingAbove(positions, triangles, position, normal, ignored))
          << triangleCount << " triangles, query " << query;
      ++(above ? yes : no);
    }
  }
  EXPECT_GT(yes, 500u);
  EXPECT_GT(no, 500u);
}

}  // namespace
}  // namespace shprt
