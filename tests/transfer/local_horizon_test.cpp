// Which directions touching geometry hides, where a drawing tells the answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "shprt/sampling/fibonacci_hemisphere.h"
#include "shprt/transfer/local_horizon.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

// Compares hidden() with a predicate on many directions of the hemisphere around the vertex normal, leaving
// out those within 1e-5 of the boundary, where margin() is small.
void expectHidden(const Mesh& mesh, std::uint32_t vertex, std::vector<std::uint32_t> touching,
                  const std::function<double(Vec3d)>& margin) {
  const SurfaceTopology topology(mesh);
  LocalHorizon horizon;
  horizon.prepare(topology, vertex, touching);
  const FibonacciHemisphere lattice(4096, kRayPacketSize);
  std::vector<float> x(4096), y(4096), z(4096);
  lattice.directions(topology.normal(vertex), 1, vertex, x.data(), y.data(), z.data());
  int hiddenCount = 0;
  for (std::size_t first = 0; first < x.size(); first += kRayPacketSize) {
    const std::uint32_t hidden = horizon.hidden({&x[first], &y[first], &z[first]});
    for (std::size_t lane = 0; lane < kRayPacketSize; ++lane) {
      const Vec3d d{x[first + lane], y[first + lane], z[first + lane]};
      const double m = margin(d);
      if (std::abs(m) < 1e-5) continue;
      ASSERT_EQ((hidden >> lane) & 1u, m > 0 ? 1u : 0u) << d.x << " " << d.y << " " << d.z;
      hiddenCount += m > 0;
    }
  }
  EXPECT_GT(hiddenCount, 0);
}

constexpr Vec3d kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

// A floor [0,1]x[0,1] in the xz plane and a wall [0,1] high along z at x = 0, sharing the positions of their
// edge.
Mesh floorAndWall(double wallX = 0, double wallBottom = 0) {
  Mesh mesh;
  test::addPatch(mesh, {0, 0, 0}, kZ, kX, 2);                                        // floor, normal +y
  test::addPatch(mesh, {wallX, wallBottom, 0}, kY - kY * wallBottom, kZ, 2, 2, kX);  // wall, normal +x
  return mesh;
}

TEST(LocalHorizon, FloorVertexInAWallCornerSeesItsQuarter) {
  const Mesh mesh = floorAndWall();
  // Vertex 3 of the floor: (0, 0, 0.5), in the middle of the edge.
  ASSERT_EQ(mesh.positions[3], (Vec3f{0, 0, 0.5f}));
  expectHidden(mesh, 3, {}, [](Vec3d d) { return -d.x; });
}

TEST(LocalHorizon, WallVertexInTheSameCornerSeesTheSameQuarter) {
  const Mesh mesh = floorAndWall();
  ASSERT_EQ(mesh.positions[10], (Vec3f{0, 0, 0.5f}));
  expectHidden(mesh, 10, {}, [](Vec3d d) { return -d.y; });
}

// Files often give normals that disagree with the winding; the side that the normal points to is the one that
// is lit.
TEST(LocalHorizon, WindingAgainstTheNormalChangesNothing) {
  Mesh mesh = floorAndWall();
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  expectHidden(mesh, 3, {}, [](Vec3d d) { return -d.x; });
  expectHidden(mesh, 10, {}, [](Vec3d d) { return -d.y; });
}

TEST(LocalHorizon, SmoothNormalInTheCornerSeesTheQuarterToo) {
  Mesh mesh = floorAndWall();
  const Vec3f smooth = toFloat(normalize(kX + kY));
  mesh.normals[3] = mesh.normals[10] = smooth;
  expectHidden(mesh, 3, {}, [](Vec3d d) { return std::max(-d.x, -d.y); });
}

TEST(LocalHorizon, CornerOfThreeWallsSeesItsEighth) {
  Mesh mesh = floorAndWall();
  test::addPatch(mesh, {0, 0, 0}, kX, kY, 2);  // a second wall, normal +z
  ASSERT_EQ(mesh.positions[0], (Vec3f{0, 0, 0}));
  expectHidden(mesh, 0, {}, [](Vec3d d) { return std::max(-d.x, -d.z); });
}

TEST(LocalHorizon, WallThatOnlyTouchesTheFloorHidesTheSame) {
  // The wall's triangles pass through the floor's edge without a vertex there.
  const Mesh mesh = floorAndWall(0, -0.7);
  std::vector<std::uint32_t> wall;
  for (std::uint32_t t = 8; t < 16; ++t) {
    // Of the wall, those triangles that hold (0, 0, 0.5): found by the caster in the program, by hand here.
    double lowY = 9, highY = -9, lowZ = 9, highZ = -9;
    for (const std::uint32_t corner : mesh.triangles[t]) {
      lowY = std::min(lowY, double(mesh.positions[corner].y)),
      highY = std::max(highY, double(mesh.positions[corner].y));
      lowZ = std::min(lowZ, double(mesh.positions[corner].z)),
      highZ = std::max(highZ, double(mesh.positions[corner].z));
    }
    if (lowY < 0 && highY > 0 && lowZ <= 0.5 && highZ >= 0.5) wall.push_back(t);
  }
  ASSERT_GE(wall.size(), 2u);
  // Those triangles are half a wall: they touch the point along a vertical edge, and hide all of x < 0
  // between them.
  expectHidden(mesh, 3, wall, [](Vec3d d) { return -d.x; });
}

TEST(LocalHorizon, LeaningWallHidesWhatLiesBehindIt) {
  for (const double degrees : {5.0, 30.0, 60.0, 120.0, 150.0}) {
    const double a = degrees * std::numbers::pi / 180;  // dihedral angle between floor (towards +x) and wall
    Mesh mesh;
    test::addPatch(mesh, {0, 0, 0}, kZ, kX, 2);
    test::addPatch(mesh, {0, 0, 0}, Vec3d{std::cos(a), std::sin(a), 0}, kZ, 2);
    expectHidden(mesh, 3, {},
                 [a](Vec3d d) { return std::sin(std::atan2(d.y, d.x) - a) * std::hypot(d.x, d.y); });
  }
}

TEST(LocalHorizon, ConvexSurfacesHideNothing) {
  for (int subdivisions = 0; subdivisions < 3; ++subdivisions) {
    const Mesh mesh = test::makeIcosphere(subdivisions);
    const SurfaceTopology topology(mesh);
    LocalHorizon horizon;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
      horizon.prepare(topology, v, {});
      EXPECT_TRUE(horizon.empty()) << v;
    }
  }
}

TEST(LocalHorizon, SmoothGrooveHidesWhatLiesBelowItsWalls) {
  // A V of two sheets rising at 40 degrees from the line x = 0, open below, with an upright normal at the
  // bottom.
  const double a = 40 * std::numbers::pi / 180;
  Mesh mesh;
  test::addPatch(mesh, {0, 0, -1}, kZ * 2.0, Vec3d{std::cos(a), std::sin(a), 0}, 2, 2, kY);
  test::addPatch(mesh, {0, 0, -1}, Vec3d{-std::cos(a), std::sin(a), 0}, kZ * 2.0, 2, 2, kY);
  ASSERT_EQ(mesh.positions[3], (Vec3f{0, 0, 0}));
  expectHidden(mesh, 3, {}, [a](Vec3d d) { return std::abs(d.x) * std::tan(a) - d.y; });
}

TEST(LocalHorizon, BothSidesOfACoincidentSheetAreClean) {
  Mesh mesh;
  test::addPatch(mesh, {0, 0, 0}, kZ, kX, 2);
  test::addPatch(mesh, {0, 0, 0}, kX, kZ, 2);
  const SurfaceTopology topology(mesh);
  LocalHorizon horizon;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    horizon.prepare(topology, v, {});
    EXPECT_TRUE(horizon.empty()) << v;
  }
}

}  // namespace
}  // namespace shprt
