// Shadowed transfer inside triangles, where it is known exactly or in closed form.
#include "shprt/transfer/sample_transfer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/facet.h"
#include "shprt/transfer/transfer_rows.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

constexpr Vec3d kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

struct Measured {
  std::vector<SurfaceSample> samples;
  SampleTransfer transfer;
};

Measured measure(const Scene& scene, double perTriangle, int rays) {
  const PreparedScene prepared(scene);
  Measured measured;
  measured.samples =
      sampleSurface(scene, prepared.topology, {.perTriangle = perTriangle, .minimum = 4, .seed = 1});
  measured.transfer = bakeSamples(prepared, measured.samples, {.degree = 3, .rays = rays, .seed = 1});
  return measured;
}

double meanVisibility(const Mesh& mesh) {
  const Scene scene = test::grey(mesh, 1);
  return measure(scene, 16, 64).transfer.meanVisibility;
}

void expectExactlyUnshadowed(const Mesh& mesh, const std::string& what) {
  const Scene scene = test::grey(mesh, 1);
  const SurfaceTopology topology(scene.mesh);
  const Measured measured = measure(scene, 16, 64);
  EXPECT_EQ(measured.transfer.meanVisibility, 1) << what;
  const UnshadowedTransfer unshadowed(3);
  std::vector<double> expected(16);
  for (std::size_t s = 0; s < measured.samples.size(); ++s) {
    const SurfaceSample& sample = measured.samples[s];
    const Facet facet(topology, sample.triangle);
    unshadowed.evaluate(facet.normalAt(static_cast<double>(sample.u), static_cast<double>(sample.v)),
                        expected);
    for (std::size_t i = 0; i < expected.size(); ++i)
      ASSERT_EQ(measured.transfer.transfer.at(s)[i], static_cast<float>(expected[i])) << what;
  }
}

// Normals along the diagonals at corners and edges: the worst that a smooth normal can be off.
Mesh smoothBox(int cells) {
  Mesh box = test::makeBox({-1, -1, -1}, {2, 2, 2}, cells);
  for (std::size_t v = 0; v < box.positions.size(); ++v) {
    const Vec3f p = box.positions[v];
    const auto outward = [](float x) { return std::abs(x) == 1 ? static_cast<double>(x) : 0.0; };
    box.normals[v] = toFloat(normalize(Vec3d{outward(p.x), outward(p.y), outward(p.z)}));
  }
  return box;
}

Mesh turnedInsideOut(Mesh mesh) {
  for (Vec3f& normal : mesh.normals) normal = -normal;
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

TEST(SampleTransfer, ConvexMeshesAreExactlyUnshadowedAtAnySizeAndPlace) {
  for (const double scale : {1e-4, 1.0, 1e6})
    for (const double away : {0.0, 1e3}) {
      const Vec3d offset = Vec3d{1, -0.5, 0.75} * (away * scale);
      const auto check = [&](const Mesh& mesh, const std::string& what) {
        expectExactlyUnshadowed(test::moved(mesh, scale, offset),
                                what + ", scale " + std::to_string(scale) + ", away " + std::to_string(away));
      };
      check(test::makeBox({-1, -1, -1}, {2, 2, 2}, 2), "hard box");
      for (const int cells : {1, 2, 3}) check(smoothBox(cells), "smooth box of " + std::to_string(cells));
      for (const int subdivisions : {0, 1, 2})
        check(test::makeIcosphere(subdivisions), "icosphere " + std::to_string(subdivisions));
    }
}

TEST(SampleTransfer, SheetsBordersAndSlopesAreClean) {
  const Vec3d u = normalize(Vec3d{0.3, 0.5, -0.8}), v = normalize(cross(u, Vec3d{0.1, 0.9, 0.4}));
  Mesh sheet;
  test::addPatch(sheet, {0.1, 0.2, 0.3}, u, v, 12);
  expectExactlyUnshadowed(sheet, "sloping sheet");
  test::addPatch(sheet, {0.1, 0.2, 0.3}, v, u, 12);
  expectExactlyUnshadowed(sheet, "both sides of a sheet");
  expectExactlyUnshadowed(test::makeBox({0, 0, 0}, {1, 1e-6, 1}, 8, 1), "thin box");
}

TEST(SampleTransfer, ClosedRoomsLetNothingIn) {
  // Inside a coarse sphere, rays that leave below a facet are outside of the room at once.
  for (const int subdivisions : {0, 1, 2})
    EXPECT_EQ(meanVisibility(turnedInsideOut(test::makeIcosphere(subdivisions))), 0) << subdivisions;
  EXPECT_EQ(meanVisibility(turnedInsideOut(smoothBox(1))), 0);
}

TEST(SampleTransfer, RaysThroughTheOwnSolidStillEndOnOtherThings) {
  // A coarse ball in a room: from each facet some rays cross the ball's inside, and all end on the walls.
  Mesh mesh = test::moved(test::makeIcosphere(0), 0.2, {0.1, 0, 0});
  const auto ball = static_cast<std::uint32_t>(mesh.triangles.size());
  test::append(mesh, turnedInsideOut(test::makeBox({-1, -1, -1}, {2, 2, 2}, 1)));
  const Scene scene = test::grey(mesh, 1);
  const Measured measured = measure(scene, 16, 256);
  EXPECT_EQ(measured.transfer.meanVisibility, 0);
  EXPECT_LT(measured.samples.front().triangle, ball);
}

TEST(SampleTransfer, BothSidesOfACurvedSheet) {
  // The outside sees everything and the inside nothing, though each lies back to back with the other.
  for (const int subdivisions : {0, 1, 2}) {
    Mesh mesh = test::makeIcosphere(subdivisions);
    const std::size_t outside = mesh.triangles.size();
    test::append(mesh, turnedInsideOut(mesh));
    const Scene scene = test::grey(mesh, 1);
    const Measured measured = measure(scene, 16, 64);
    for (std::size_t s = 0; s < measured.samples.size(); ++s) {
      const bool seen = measured.samples[s].triangle < outside;
      const double share =
          static_cast<double>(measured.transfer.transfer.at(s)[0]) * std::sqrt(4 * std::numbers::pi);
      ASSERT_NEAR(share, seen ? 1 : 0, 1e-6)
          << subdivisions << " subdivisions, triangle " << measured.samples[s].triangle << " of " << outside;
    }
  }
}

TEST(SampleTransfer, KnowsWhatIsInsideASolid) {
  // A box pierces a floor, stands on it, or hovers a little above it: only in the last case can anyone see
  // the floor below it.
  for (const double bottom : {-0.2, 0.0, 0.01}) {
    Mesh mesh;
    test::addPatch(mesh, {-2, 0, -2}, kZ * 4, kX * 4, 3);
    const std::size_t floorTriangles = mesh.triangles.size();
    test::append(mesh, test::makeBox({-0.5, bottom, -0.25}, {1, 0.5, 0.5}, 1));
    const Scene scene = test::grey(mesh, 1);
    const Measured measured = measure(scene, 64, 64);
    std::vector<std::uint32_t> inside;
    for (std::uint32_t s = 0; s < measured.samples.size(); ++s) {
      const SurfaceSample& sample = measured.samples[s];
      if (sample.triangle >= floorTriangles) break;
      const Triangle& t = mesh.triangles[sample.triangle];
      const Vec3f p = mesh.positions[t[0]] * (1 - sample.u - sample.v) + mesh.positions[t[1]] * sample.u +
                      mesh.positions[t[2]] * sample.v;
      if (std::abs(p.x) < 0.5f && std::abs(p.z) < 0.25f) inside.push_back(s);
    }
    EXPECT_GT(inside.size(), 10u);
    if (bottom > 0) inside.clear();
    std::vector<std::uint32_t> buried = measured.transfer.buried;
    std::erase_if(buried, [&](std::uint32_t s) { return measured.samples[s].triangle >= floorTriangles; });
    EXPECT_EQ(buried, inside) << "bottom at " << bottom;
  }
}

TEST(SampleTransfer, WallHidesItsFormFactor) {
  // A wall of height h, endless along z, hides (1 - d / sqrt(d^2 + h^2)) / 2 of a floor point at distance d.
  const double height = 0.5, length = 200;
  Mesh mesh;
  test::addPatch(mesh, {0, 0, -0.5}, kZ, kX);
  const std::size_t floorTriangles = mesh.triangles.size();
  test::addPatch(mesh, {0, 0, -length / 2}, kY * height, kZ * length);
  const Scene scene = test::grey(mesh, 1);
  const Measured measured = measure(scene, 64, 1024);
  int checked = 0;
  for (std::size_t s = 0; s < measured.samples.size(); ++s) {
    const SurfaceSample& sample = measured.samples[s];
    if (sample.triangle >= floorTriangles) break;
    const Triangle& t = mesh.triangles[sample.triangle];
    const double x =
        static_cast<double>(mesh.positions[t[0]].x * (1 - sample.u - sample.v) +
                            mesh.positions[t[1]].x * sample.u + mesh.positions[t[2]].x * sample.v);
    const double hidden = 0.5 * (1 - x / std::hypot(x, height));
    const double share =
        static_cast<double>(measured.transfer.transfer.at(s)[0]) * std::sqrt(4 * std::numbers::pi);
    // Of 1024 stratified rays about sqrt(1024) cells lie on the boundary: a deviation of 16 / 1024 is 5
    // sigma.
    EXPECT_NEAR(share, 1 - hidden, 0.016) << "distance " << x;
    ++checked;
  }
  EXPECT_GE(checked, 8);
}

TEST(SampleTransfer, SameBitsForAnyNumberOfThreads) {
  Mesh mesh = test::makeIcosphere(1);
  test::addPatch(mesh, {-2, -1, -2}, kZ * 4, kX * 4, 2);
  const Scene scene = test::grey(mesh, 1);
  setThreadCount(1);
  const Measured one = measure(scene, 8, 64);
  setThreadCount(0);
  const Measured many = measure(scene, 8, 64);
  EXPECT_EQ(one.transfer.transfer.values, many.transfer.transfer.values);
  EXPECT_EQ(one.transfer.meanVisibility, many.transfer.meanVisibility);
  EXPECT_GT(one.transfer.meanVisibility, 0.5);
  EXPECT_LT(one.transfer.meanVisibility, 1);
}

}  // namespace
}  // namespace shprt
