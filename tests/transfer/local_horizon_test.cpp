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

// Which place nearest() tells for directions that a predicate picks; all of them must agree.
void expectFirst(const Mesh& mesh, std::uint32_t vertex, std::vector<std::uint32_t> touching,
                 const std::function<bool(Vec3d)>& picks, const std::function<void(SurfacePoint)>& check) {
  const SurfaceTopology topology(mesh);
  LocalHorizon horizon;
  horizon.prepare(topology, vertex, touching);
  const FibonacciHemisphere lattice(1024, kRayPacketSize);
  std::vector<float> x(1024), y(1024), z(1024);
  lattice.directions(topology.normal(vertex), 1, vertex, x.data(), y.data(), z.data());
  int picked = 0;
  for (std::size_t first = 0; first < x.size(); first += kRayPacketSize) {
    const RayPacket rays{&x[first], &y[first], &z[first]};
    RayPacketHits hits;
    const std::uint32_t hidden = horizon.nearest(rays, hits);
    ASSERT_EQ(hidden, horizon.hidden(rays));
    for (std::size_t lane = 0; lane < kRayPacketSize; ++lane) {
      if (!picks({x[first + lane], y[first + lane], z[first + lane]})) continue;
      ASSERT_TRUE((hidden >> lane) & 1u);
      check({hits.triangle[lane], hits.u[lane], hits.v[lane]});
      ++picked;
    }
  }
  EXPECT_GT(picked, 10);
}

Vec3d placeOf(const Mesh& mesh, SurfacePoint place) {
  const auto& [a, b, c] = mesh.triangles[place.triangle];
  const double u = static_cast<double>(place.u), v = static_cast<double>(place.v);
  return toDouble(mesh.positions[a]) * (1 - u - v) + toDouble(mesh.positions[b]) * u +
         toDouble(mesh.positions[c]) * v;
}

TEST(LocalHorizon, TellsTheWallThatHidesAndWhereTheVertexLiesOnIt) {
  for (const bool touchingOnly : {false, true}) {
    const Mesh mesh = floorAndWall(0, touchingOnly ? -0.7 : 0);
    // Of the wall, the two triangles with an edge that passes through (0, 0, 0.5).
    std::vector<std::uint32_t> wall;
    for (std::uint32_t t = 8; touchingOnly && t < 16; ++t) {
      int atLine = 0, above = 0;
      for (const std::uint32_t corner : mesh.triangles[t]) {
        if (mesh.positions[corner].z != 0.5f) continue;
        ++atLine;
        above += mesh.positions[corner].y > 0;
      }
      if (atLine == 2 && above == 1) wall.push_back(t);
    }
    ASSERT_EQ(wall.size(), touchingOnly ? 2u : 0u);
    expectFirst(
        mesh, 3, wall, [](Vec3d d) { return d.x < -1e-3; },
        [&](SurfacePoint place) {
          EXPECT_GE(place.triangle, 8u);
          EXPECT_LE(length(placeOf(mesh, place) - Vec3d{0, 0, 0.5}), 1e-6);
        });
  }
}

// Of two walls that rise from one line the one that leans over the floor is met first.
TEST(LocalHorizon, TellsTheFirstOfTwoWalls) {
  for (const bool leaningFirst : {false, true}) {
    Mesh mesh;
    test::addPatch(mesh, {0, 0, 0}, kZ, kX, 2);
    const Vec3d leaning{std::sqrt(0.5), std::sqrt(0.5), 0};
    test::addPatch(mesh, {0, 0, 0}, leaningFirst ? leaning : kY, kZ, 2);
    test::addPatch(mesh, {0, 0, 0}, leaningFirst ? kY : leaning, kZ, 2);
    expectFirst(
        mesh, 3, {}, [](Vec3d d) { return d.x < -1e-3; },
        [&](SurfacePoint place) { EXPECT_EQ(place.triangle < 16, leaningFirst); });
  }
}

// A floor that goes on under a wall without thickness: the steps tell its two sides apart.
TEST(LocalHorizon, StepsStandOnBothSidesOfAWallOnTheFloor) {
  Mesh mesh;
  test::addPatch(mesh, {-1, 0, 0}, kZ, kX * 2.0, 2);
  test::addPatch(mesh, {0, 0, 0}, kY, kZ, 2, 2, kX);
  const std::uint32_t vertex = 4;
  ASSERT_EQ(mesh.positions[vertex], (Vec3f{0, 0, 0.5f}));
  const SurfaceTopology topology(mesh);
  LocalHorizon horizon;
  horizon.prepare(topology, vertex, {});
  const FibonacciHemisphere lattice(256, kRayPacketSize);
  std::vector<float> x(256), y(256), z(256);
  lattice.directions(kY, 1, 0, x.data(), y.data(), z.data());
  int onSide[2] = {0, 0};
  for (std::size_t step = 0; step < horizon.stepCount(); ++step) {
    horizon.stepAlong(step);
    int hidden[2] = {0, 0}, rays[2] = {0, 0};
    for (std::size_t first = 0; first < x.size(); first += kRayPacketSize) {
      const std::uint32_t mask = horizon.hidden({&x[first], &y[first], &z[first]});
      for (std::size_t lane = 0; lane < kRayPacketSize; ++lane) {
        const bool towardsX = x[first + lane] > 0;
        ++rays[towardsX];
        hidden[towardsX] += mask >> lane & 1u;
      }
    }
    const int side = hidden[0] == 0 ? 0 : 1;
    EXPECT_EQ(hidden[side], 0) << step;
    EXPECT_EQ(hidden[1 - side], rays[1 - side]) << step;
    ++onSide[side];
  }
  EXPECT_GT(onSide[0], 0);
  EXPECT_GT(onSide[1], 0);
}

// A disc of thin triangles around one vertex has few steps, and one where nothing stands on it.
TEST(LocalHorizon, StepsAreFew) {
  for (const bool withWall : {false, true}) {
    Mesh mesh;
    constexpr std::uint32_t kSlivers = 500;
    mesh.positions.push_back({});
    for (std::uint32_t k = 0; k < kSlivers; ++k) {
      const double angle = 2 * std::numbers::pi * k / kSlivers;
      mesh.positions.push_back(toFloat({std::sin(angle), 0, std::cos(angle)}));
      mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % kSlivers});
    }
    mesh.normals.assign(mesh.positions.size(), {0, 1, 0});
    if (withWall) test::addPatch(mesh, {}, kY, kZ, 1);
    const SurfaceTopology topology(mesh);
    LocalHorizon horizon;
    horizon.prepare(topology, 0, {});
    if (withWall) {
      EXPECT_GE(horizon.stepCount(), 16u);
      EXPECT_LE(horizon.stepCount(), 36u);
    } else {
      EXPECT_EQ(horizon.stepCount(), 1u);
    }
  }
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
