// Exact frames, welded positions, and the ray caster against geometry that can be worked out by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "shprt/mesh/position_ids.h"
#include "shprt/scene/point_triangle_distance.h"
#include "shprt/scene/ray_caster.h"
#include "shprt/scene/scene_frame.h"

namespace shprt {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

TEST(SceneFrame, IsExactAtAnySizeAndPlace) {
  const std::vector<Vec3f> shape = {{0, 0, 0}, {1, 0.5f, 0.25f}, {0.125f, 1, 0.75f}};
  for (const float size : {1e-30f, 1e-4f, 1.0f, 1e6f, 1e30f})
    for (const float away : {0.0f, -3.0f, 1e5f, -1e5f}) {
      std::vector<Vec3f> positions;
      for (const Vec3f& p : shape)
        positions.push_back({p.x * size + away * size, p.y * size - away * size, p.z * size});
      const SceneFrame frame = chooseSceneFrame(positions);
      EXPECT_EQ(std::exp2(std::round(std::log2(frame.scale))), frame.scale);
      const std::vector<Vec3f> moved = toScene(frame, positions);
      // Far away, what is left is of the size of the shape.
      for (const Vec3f& p : moved) EXPECT_LT(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 8);
      double extent = 0;
      for (std::size_t i = 0; i < moved.size(); ++i)
        for (std::size_t j = 0; j < moved.size(); ++j) {
          // Differences survive bit for bit.
          const Vec3d before = toDouble(positions[i]) - toDouble(positions[j]);
          const Vec3d after = toDouble(moved[i]) - toDouble(moved[j]);
          EXPECT_EQ(before * frame.scale, after);
          extent = std::max({extent, std::abs(after.x), std::abs(after.y), std::abs(after.z)});
        }
      EXPECT_GE(extent, 1);
      EXPECT_LT(extent, 2);
    }
}

TEST(PositionIds, AreDistinctByBitsWithOneZero) {
  const std::vector<Vec3f> positions = {{0, 1, 2}, {0, 1, 2.0000002f}, {-0.0f, 1, 2}, {0, 1, 2}};
  EXPECT_EQ(distinctPositionIds(positions), (std::vector<std::uint32_t>{0, 1, 0, 0}));
  const std::vector<Vec3f> normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0}};
  EXPECT_EQ(distinctPointIds(positions, normals), (std::vector<std::uint32_t>{0, 1, 0, 2}));
}

TEST(PositionIds, SurviveManyCollidingKeys) {
  std::vector<Vec3f> positions;
  for (int i = 0; i < 20000; ++i)
    positions.push_back({static_cast<float>(i % 100), static_cast<float>(i / 100 % 100), 0});
  const auto ids = distinctPositionIds(positions);
  for (int i = 0; i < 20000; ++i)
    ASSERT_EQ(ids[static_cast<std::size_t>(i)], static_cast<std::uint32_t>(i % 10000));
}

TEST(PointTriangleDistance, CoversFaceEdgesCornersAndSlivers) {
  const Vec3d a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  EXPECT_DOUBLE_EQ(pointTriangleDistance({1, 1, -3}, a, b, c), 3);
  EXPECT_DOUBLE_EQ(pointTriangleDistance({2, -2, 0}, a, b, c), 2);
  EXPECT_DOUBLE_EQ(pointTriangleDistance({7, -4, 0}, a, b, c), 5);
  EXPECT_NEAR(pointTriangleDistance({4, 4, 0}, a, b, c), std::sqrt(8.0), 1e-15);
  EXPECT_DOUBLE_EQ(pointTriangleDistance({1, 2, 0}, a, b, {2, 0, 0}), 2);
}

RayPacket packetOf(const std::array<std::vector<float>, 3>& d) {
  return {d[0].data(), d[1].data(), d[2].data()};
}

TEST(RayCaster, SeesAQuadInItsLanesOnly) {
  const std::vector<Vec3f> positions = {{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}};
  const RayCaster caster(positions, Triangles{{0, 1, 2}, {0, 2, 3}});
  std::array<std::vector<float>, 3> d;
  std::uint32_t expected = 0;
  for (int lane = 0; lane < kRayPacketSize; ++lane) {
    // Rays fan out along x; the quad ends at x/z = 1/2.
    const Vec3d direction = normalize({-0.975 + 0.13 * lane, 0.1, 1});
    d[0].push_back(static_cast<float>(direction.x));
    d[1].push_back(static_cast<float>(direction.y));
    d[2].push_back(static_cast<float>(direction.z));
    if (std::abs(direction.x / direction.z) < 0.5) expected |= 1u << lane;
  }
  const IgnoredTriangles none;
  EXPECT_EQ(caster.occluded({0, 0, 0}, packetOf(d), 0xffff, none), expected);
  EXPECT_EQ(caster.occluded({0, 0, 0}, packetOf(d), 0x0f0f, none), expected & 0x0f0fu);
  EXPECT_EQ(caster.occluded({0, 0, 3}, packetOf(d), 0xffff, none), 0u);
}

TEST(RayCaster, PassesThroughIgnoredTriangles) {
  const std::vector<Vec3f> positions = {{-9, -9, 1}, {9, -9, 1}, {0, 9, 1},
                                        {-9, -9, 2}, {9, -9, 2}, {0, 9, 2}};
  const std::array<std::vector<float>, 3> up = {std::vector<float>(16, 0), std::vector<float>(16, 0),
                                                std::vector<float>(16, 1)};
  const RayCaster caster(positions, Triangles{{0, 1, 2}, {3, 4, 5}});
  const std::vector<std::uint32_t> first = {0}, second = {1};
  const auto isHit = [&](const IgnoredTriangles& ignored) {
    return caster.occluded({0, 0, 0}, packetOf(up), 1, ignored) == 1u;
  };
  EXPECT_TRUE(isHit({}));
  EXPECT_TRUE(isHit({first, {}, 0}));  // the one behind still counts
  EXPECT_TRUE(isHit({{}, second, 0}));
  EXPECT_FALSE(isHit({first, second, 0}));
  EXPECT_FALSE(isHit({second, first, 0}));
  EXPECT_TRUE(isHit({first, {}, 1.5f}));
  EXPECT_FALSE(isHit({{}, {}, 2.5f}));  // rays start behind both
  // Long lists are searched another way.
  std::vector<std::uint32_t> many = {0};
  for (std::uint32_t i = 2; i < 100; ++i) many.push_back(i);
  EXPECT_TRUE(isHit({many, {}, 0}));
  EXPECT_FALSE(isHit({many, second, 0}));
}

TEST(RayCaster, IntersectGivesDistanceTriangleAndBarycentrics) {
  const std::vector<Vec3f> positions = {{0, 0, 5}, {4, 0, 5}, {0, 4, 5}};
  const RayCaster caster(positions, Triangles{{0, 1, 2}});
  const RayHit hit = caster.intersect({1, 2, 0}, {0, 0, 1});
  EXPECT_FLOAT_EQ(hit.distance, 5);
  EXPECT_EQ(hit.triangle, 0u);
  EXPECT_NEAR(hit.u, 0.25, 1e-6);
  EXPECT_NEAR(hit.v, 0.5, 1e-6);
  EXPECT_LT(caster.intersect({1, 2, 0}, {0, 0, -1}).distance, 0);
}

TEST(RayCaster, KnowsWhatEmbreeHolds) {
  std::vector<Vec3f> positions;
  Triangles triangles;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    positions.push_back({float(i % 50), float(i / 50), float(i % 7)});
    if (i >= 2) triangles.push_back({i, i - 1, i - 2});
  }
  // At least the copy of the mesh, and not more than a kilobyte per triangle beyond what any mesh costs.
  const RayCaster caster(positions, triangles);
  EXPECT_GT(caster.peakMemory(), 12 * (positions.size() + triangles.size()));
  EXPECT_LT(caster.peakMemory(), 1000 * triangles.size() + (std::size_t{16} << 20));
}

TEST(RayCaster, FindsTouchingTriangles) {
  const std::vector<Vec3f> positions = {{0, 0, 0},     {1, 0, 0},     {0, 1, 0},
                                        {0, 0, 1e-3f}, {1, 0, 1e-3f}, {0, 1, 1e-3f}};
  const RayCaster caster(positions, Triangles{{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(caster.trianglesNear({0.25f, 0.25f, 0}, 1e-6, {}), std::vector<std::uint32_t>{0});
  EXPECT_EQ(caster.trianglesNear({0.25f, 0.25f, 0}, 2e-3, {}), (std::vector<std::uint32_t>{0, 1}));
  const std::vector<std::uint32_t> first = {0};
  EXPECT_EQ(caster.trianglesNear({0.25f, 0.25f, 0}, 2e-3, first), std::vector<std::uint32_t>{1});
  EXPECT_TRUE(caster.trianglesNear({0.75f, 0.75f, 0}, 1e-6, {}).empty());
}

}  // namespace
}  // namespace shprt
