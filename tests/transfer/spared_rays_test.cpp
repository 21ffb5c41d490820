// Points below nothing need no rays, and nobody can tell from their transfer.
#include <gtest/gtest.h>

#include <filesystem>

#include "shprt/mesh/load_mesh.h"
#include "shprt/transfer/bake.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

BakeStatistics expectSameTransfer(const Scene& scene, int rays, const std::string& what) {
  const ShadowedOptions options{.degree = 3, .rays = rays, .seed = 5};
  ShadowedOptions everything = options;
  everything.traceEverything = true;
  const Bake spared = bakeShadowed(scene, options), traced = bakeShadowed(scene, everything);
  EXPECT_EQ(spared.transfer.values, traced.transfer.values) << what;
  EXPECT_EQ(spared.statistics.fullyVisible, traced.statistics.fullyVisible) << what;
  EXPECT_EQ(spared.statistics.meanVisibility, traced.statistics.meanVisibility) << what;
  EXPECT_EQ(spared.statistics.rays, traced.statistics.rays) << what;
  EXPECT_EQ(traced.statistics.raysSpared, 0u) << what;
  EXPECT_EQ(traced.statistics.unoccludedPoints, 0u) << what;
  EXPECT_LE(spared.statistics.unoccludedPoints * static_cast<std::uint64_t>(rays),
            spared.statistics.raysSpared);
  EXPECT_LE(spared.statistics.raysSpared, spared.statistics.rays);
  return spared.statistics;
}

void expectNothingTraced(const Mesh& mesh, const std::string& what) {
  const BakeStatistics statistics = expectSameTransfer(test::grey(mesh, 0.8f), 64, what);
  EXPECT_EQ(statistics.raysSpared, statistics.rays) << what;
  EXPECT_EQ(statistics.unoccludedPoints, statistics.samplePoints) << what;
}

TEST(SparedRays, ConvexScenesTraceNothingAtAnySizeAndPlace) {
  for (const double scale : {1e-30, 1.0, 1e30})
    for (const double away : {0.0, 1e4}) {
      const Vec3d offset = Vec3d{1, -0.5, 0.75} * (away * scale);
      const std::string where =
          "scale " + std::to_string(scale) + ", " + std::to_string(away) + " sizes away";
      expectNothingTraced(test::moved(test::makeBox({-1, -1, -1}, {2, 2, 2}, 4), scale, offset),
                          "box, " + where);
      expectNothingTraced(test::moved(test::makeIcosphere(away > 0 ? 1 : 3), scale, offset),
                          "sphere, " + where);
    }
  Mesh sheet;
  test::addPatch(sheet, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 8);
  test::addPatch(sheet, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 8);
  expectNothingTraced(sheet, "both sides of a sheet");
}

TEST(SparedRays, BoxesApartTraceOnlyAcrossTheGap) {
  Mesh boxes = test::makeBox({-1, -1, -1}, {1, 2, 2}, 3);
  test::append(boxes, test::makeBox({2, -1, -1}, {1, 2, 2}, 3));
  const BakeStatistics statistics = expectSameTransfer(test::grey(boxes, 0.8f), 64, "boxes");
  // Two of twelve faces look at the other box, with 16 points each.
  EXPECT_EQ(statistics.samplePoints, 12u * 16);
  EXPECT_EQ(statistics.unoccludedPoints, 10u * 16);
  EXPECT_EQ(statistics.raysSpared, 10u * 16 * 64);
}

TEST(SparedRays, RoomWithABallTracesEverything) {
  Mesh room = test::makeBox({-2, -2, -2}, {4, 4, 4}, 2);
  for (Vec3f& n : room.normals) n = -n;
  for (Triangle& t : room.triangles) std::swap(t[1], t[2]);
  test::append(room, test::makeIcosphere(1));
  EXPECT_EQ(expectSameTransfer(test::grey(room, 1), 64, "room").raysSpared, 0u);
}

TEST(SparedRays, TransferOfTheProjectsMeshesIsTheSame) {
  for (const char* name : {"knot.ply", "courtyard.obj"}) {
    const Mesh mesh = loadMesh(std::filesystem::path(SHPRT_SOURCE_DIR "/data") / name).mesh;
    expectSameTransfer(test::grey(mesh, 0.8f), 64, name);
  }
}

TEST(SparedRays, TransferOfSharedMeshesIsTheSame) {
  const std::filesystem::path folder = SHPRT_SHARED_DIR "/data/meshes";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "SKIPPED: " << folder << " is absent";
  for (const char* name : {"fandisk.obj", "cornell_box.obj", "two_rooms.obj", "sphere_plane.obj",
                           "teapot.obj", "suzanne.obj", "spot.obj", "featuretype.STL"}) {
    const Mesh mesh = loadMesh(folder / name).mesh;
    expectSameTransfer(test::grey(mesh, 0.8f), 32, name);
  }
}

}  // namespace
}  // namespace shprt
