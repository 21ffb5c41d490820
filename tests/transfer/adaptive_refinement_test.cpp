// Refinement puts vertices where shadows need them, and nowhere else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "shprt/base/parallel.h"
#include "shprt/mesh/load_mesh.h"
#include "shprt/transfer/adaptive_refinement.h"
#include "shprt/transfer/bake.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

constexpr double kSide = 4;  // of the floor
constexpr int kDegree = 2;
// Clamped cosine's A_l / pi, squared and summed over the bands with (2l + 1) / 4 pi: 1, 2/3, 1/4.
const double kUnshadowedNorm = std::sqrt((1 + 3 * 4.0 / 9 + 5 / 16.0) / (4 * std::numbers::pi));

// A square floor in cells x cells quads that receives, and boxes over it that block.
Scene floorUnder(const Mesh& boxes, int cells) {
  Mesh mesh;
  test::addPatch(mesh, {0, 0, 0}, {0, 0, kSide}, {kSide, 0, 0}, cells);
  const std::size_t floorVertices = mesh.positions.size();
  test::append(mesh, boxes);
  Scene scene = test::grey(mesh, 1);
  scene.objects.resize(2);
  scene.objects[1].role = Role::kBlocker;
  for (std::size_t v = floorVertices; v < mesh.positions.size(); ++v) scene.vertexObjects[v] = 1;
  return scene;
}

Mesh hoveringBox() {
  return test::makeBox({1.3, 0.5, 1.7}, {0.9, 0.4, 1.1}, 1);
}

// Scene's transfer at a place on the floor, interpolated in the triangle there.
std::vector<double> transferAt(const Scene& scene, const TransferCoefficients& transfer, double x, double z) {
  std::vector<double> result;
  for (const Triangle& t : scene.mesh.triangles) {
    if (!scene.isReceiver(t[0])) continue;
    Vec3d p[3];
    for (std::size_t i = 0; i < 3; ++i) p[i] = toDouble(scene.mesh.positions[t[i]]) - Vec3d{x, 0, z};
    const auto twice = [&](int a, int b) { return p[b].x * p[a].z - p[a].x * p[b].z; };
    const double w[3] = {twice(1, 2), twice(2, 0), twice(0, 1)}, whole = w[0] + w[1] + w[2];
    if (std::min({w[0] / whole, w[1] / whole, w[2] / whole}) < -1e-6) continue;
    for (int i = 0; i < transfer.rows(); ++i) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += w[k] / whole * static_cast<double>(transfer.row(0, i)[t[k]]);
      result.push_back(sum);
    }
    return result;
  }
  return result;
}

// RMS over places on the floor of the difference between what a scene interpolates there and the truth, over
// the unshadowed norm.
class FloorError {
 public:
  explicit FloorError(const Mesh& boxes)
      : grid_(floorUnder(boxes, 45)),
        truth_(bakeShadowed(grid_, {.degree = kDegree, .rays = 1024, .seed = 11}).transfer) {}

  double of(const Scene& scene) const {
    const Bake baked = bakeShadowed(scene, {.degree = kDegree, .rays = 1024, .seed = 12});
    double sum = 0;
    std::size_t places = 0;
    for (std::uint32_t v = 0; v < grid_.mesh.positions.size(); ++v) {
      if (!grid_.isReceiver(v)) continue;
      const Vec3d p = toDouble(grid_.mesh.positions[v]);
      const std::vector<double> interpolated = transferAt(scene, baked.transfer, p.x, p.z);
      if (interpolated.empty()) ADD_FAILURE() << "the floor has a hole at " << p.x << ", " << p.z;
      for (std::size_t i = 0; i < interpolated.size(); ++i) {
        const double d = interpolated[i] - static_cast<double>(truth_.row(0, static_cast<int>(i))[v]);
        sum += d * d;
      }
      ++places;
    }
    return std::sqrt(sum / static_cast<double>(places)) / kUnshadowedNorm;
  }

 private:
  Scene grid_;
  TransferCoefficients truth_;
};

std::size_t receivers(const Scene& scene) {
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < scene.mesh.positions.size(); ++v) count += scene.isReceiver(v) ? 1 : 0;
  return count;
}

TEST(AdaptiveRefinement, AFloorOfTwoTrianglesCarriesTheShadowOfABox) {
  const Scene coarse = floorUnder(hoveringBox(), 1);
  const AdaptiveRefinement fine = refineAdaptively(coarse, {});
  const FloorError error(hoveringBox());
  const double before = error.of(coarse), after = error.of(fine.refined.scene);
  EXPECT_LT(after, before / 8);
  EXPECT_LT(after, AdaptiveRefinementOptions{}.tolerance / 2);

  // Even spacing with as many vertices does worse.
  const std::size_t vertices = receivers(fine.refined.scene);
  const int cells = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(vertices)))) - 1;
  const Scene even = floorUnder(hoveringBox(), cells);
  ASSERT_GE(receivers(even), vertices);
  EXPECT_LT(after, error.of(even) / 1.4);

  EXPECT_EQ(fine.report.stop, RefinementStop::kTolerance);
  EXPECT_LE(fine.report.remainingDifference, AdaptiveRefinementOptions{}.tolerance);
  EXPECT_EQ(fine.report.verticesBefore, coarse.mesh.positions.size());
  EXPECT_EQ(fine.report.verticesAfter, fine.refined.scene.mesh.positions.size());
  EXPECT_EQ(fine.report.trianglesAfter, fine.refined.triangleParents.size());
  for (std::size_t v = 0; v < coarse.mesh.positions.size(); ++v)
    EXPECT_EQ(fine.refined.scene.mesh.positions[v], coarse.mesh.positions[v]);
}

TEST(AdaptiveRefinement, VerticesGoWhereTheShadowIs) {
  // A small box near one corner; from the far half it fills little of the sky.
  const Scene coarse = floorUnder(test::makeBox({0.4, 0.15, 0.5}, {0.3, 0.2, 0.4}, 1), 1);
  const Scene fine = refineAdaptively(coarse, {}).refined.scene;
  std::size_t near = 0, far = 0;
  for (std::uint32_t v = 0; v < fine.mesh.positions.size(); ++v) {
    if (!fine.isReceiver(v)) continue;
    const Vec3f p = fine.mesh.positions[v];
    ++(std::max(p.x, p.z) > 2 ? far : near);
  }
  EXPECT_GT(near, 20u);
  EXPECT_LT(4 * far, near) << "three quarters of the floor";
}

TEST(AdaptiveRefinement, WhatNothingShadesComesBackUnchanged) {
  Scene scene = test::grey(test::makeBox({-1, -1, -1}, {2, 2, 2}, 1), 0.5f);
  for (std::size_t v = 0; v < scene.albedo.size(); ++v) scene.albedo[v].x = static_cast<float>(v % 3) / 3;
  scene.materials[0].emission = {1, 1, 1};
  const AdaptiveRefinement same = refineAdaptively(scene, {});
  EXPECT_EQ(same.refined.scene.mesh.positions, scene.mesh.positions);
  EXPECT_EQ(same.refined.scene.mesh.triangles, scene.mesh.triangles);
  EXPECT_EQ(same.refined.scene.albedo, scene.albedo);
  EXPECT_EQ(same.report.rays, 0u);
  EXPECT_EQ(same.report.remainingDifference, 0);
}

TEST(AdaptiveRefinement, MeshesFinerThanTheFinestEdgeCostNoRays) {
  const Scene scene = floorUnder(hoveringBox(), 200);
  const AdaptiveRefinement same = refineAdaptively(scene, {.finest = 1.0 / 100});
  EXPECT_EQ(same.refined.scene.mesh.triangles, scene.mesh.triangles);
  EXPECT_EQ(same.report.rays, 0u);
  EXPECT_TRUE(same.report.levels.empty());
}

TEST(AdaptiveRefinement, ContactShadowsEndAtTheFinestEdge) {
  const Mesh standing = test::makeBox({1.3, 0, 1.7}, {0.9, 0.8, 1.1}, 1);
  const Scene coarse = floorUnder(standing, 1);
  const AdaptiveRefinementOptions options{.finest = 1.0 / 32};
  const AdaptiveRefinement fine = refineAdaptively(coarse, options);
  EXPECT_EQ(fine.report.stop, RefinementStop::kFinest);
  // Half of the light is lost at once where the floor meets the box.
  EXPECT_GT(fine.report.remainingDifference, options.tolerance);
  const MeshEdges edges = findEdges(fine.refined.scene.mesh);
  for (const double length : edges.lengths) EXPECT_GT(length, 0.3 * kSide / 32);
  // A band of the finest edges around the box's foot, and not over all of the floor.
  EXPECT_LT(receivers(fine.refined.scene), 600u);
  const FloorError error(standing);
  EXPECT_LT(error.of(fine.refined.scene), error.of(coarse) / 3);
}

TEST(AdaptiveRefinement, TheVertexLimitHoldsAndTheWorstGoesFirst) {
  const Scene coarse = floorUnder(hoveringBox(), 1);
  const AdaptiveRefinement fine = refineAdaptively(coarse, {.growth = 1, .extraVertices = 25});
  EXPECT_EQ(fine.report.stop, RefinementStop::kVertexLimit);
  EXPECT_LE(fine.report.verticesAfter, fine.report.verticesBefore + 25);
  EXPECT_GT(fine.report.verticesAfter, fine.report.verticesBefore + 15);
  EXPECT_GT(fine.report.remainingDifference, AdaptiveRefinementOptions{}.tolerance);
  const FloorError error(hoveringBox());
  EXPECT_LT(error.of(fine.refined.scene), error.of(coarse) / 2);
  const AdaptiveRefinement none = refineAdaptively(coarse, {.growth = 1, .extraVertices = 0});
  EXPECT_EQ(none.refined.scene.mesh.triangles, coarse.mesh.triangles);
}

TEST(AdaptiveRefinement, BlockersAreRefinedOnDemand) {
  // A box over a slab, which it shades as it would the floor.
  Mesh boxes = hoveringBox();
  test::append(boxes, test::makeBox({0.5, 0.1, 0.5}, {3, 0.1, 3}, 1));
  const Scene coarse = floorUnder(boxes, 1);
  const auto blockerTriangles = [](const Scene& scene) {
    return std::count_if(scene.mesh.triangles.begin(), scene.mesh.triangles.end(),
                         [&](const Triangle& t) { return !scene.isReceiver(t[0]); });
  };
  ASSERT_EQ(blockerTriangles(coarse), 24);
  EXPECT_EQ(blockerTriangles(refineAdaptively(coarse, {}).refined.scene), 24);
  EXPECT_GT(blockerTriangles(refineAdaptively(coarse, {.objects = RefinedObjects::kAll}).refined.scene), 60);
}

TEST(AdaptiveRefinement, ThreadsDoNotMatterAndSeedsDoOnlyLittle) {
  const Scene coarse = floorUnder(hoveringBox(), 1);
  setThreadCount(1);
  const AdaptiveRefinement one = refineAdaptively(coarse, {});
  setThreadCount(3);
  const AdaptiveRefinement three = refineAdaptively(coarse, {});
  setThreadCount(0);
  EXPECT_EQ(one.refined.scene.mesh.positions, three.refined.scene.mesh.positions);
  EXPECT_EQ(one.refined.scene.mesh.triangles, three.refined.scene.mesh.triangles);
  EXPECT_EQ(one.report.remainingDifference, three.report.remainingDifference);
  const double vertices = static_cast<double>(one.report.verticesAfter);
  EXPECT_NEAR(static_cast<double>(refineAdaptively(coarse, {.seed = 2}).report.verticesAfter), vertices,
              0.2 * vertices);
}

TEST(AdaptiveRefinement, NoiseDoesNotRefineAFineMesh) {
  const Scene knot = test::grey(loadMesh(SHPRT_SOURCE_DIR "/data/knot.ply").mesh, 0.5f);
  // With so few rays a plain difference is often above the tolerance by noise alone.
  const AdaptiveRefinement same = refineAdaptively(knot, {.rays = 64});
  ASSERT_GT(same.report.rays, 0u);
  EXPECT_LE(static_cast<double>(same.report.verticesAfter),
            1.02 * static_cast<double>(same.report.verticesBefore));
}

TEST(AdaptiveRefinement, TheBunnyHardlyChanges) {
  const std::filesystem::path file = SHPRT_SHARED_DIR "/data/meshes/stanford-bunny.obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "SKIPPED: " << file << " is not there";
  const Scene bunny = test::grey(loadMesh(file).mesh, 0.5f);
  const AdaptiveRefinement fine = refineAdaptively(bunny, {});
  // Only where it is open below, and in a few creases, are neighbours' shadows far apart.
  EXPECT_LE(static_cast<double>(fine.report.verticesAfter),
            1.05 * static_cast<double>(fine.report.verticesBefore));
}

// A convex cone of long triangles: nothing can shade it, so there is nothing to carry.
TEST(AdaptiveRefinement, LeavesAloneWhatNothingShades) {
  Mesh mesh;
  constexpr int kSides = 60;
  mesh.positions.push_back({0, 1, 0});
  mesh.normals.push_back({0, 1, 0});
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    mesh.positions.push_back(toFloat(Vec3d{std::cos(angle), 0, -std::sin(angle)}));
    mesh.normals.push_back(toFloat(normalize(Vec3d{std::cos(angle), 1, -std::sin(angle)})));
    mesh.triangles.push_back(
        {0, static_cast<std::uint32_t>(1 + i), static_cast<std::uint32_t>(1 + (i + 1) % kSides)});
  }
  const AdaptiveRefinement result = refineAdaptively(test::grey(mesh, 0.5f), {});
  EXPECT_EQ(result.report.verticesAfter, mesh.positions.size());
  EXPECT_EQ(result.report.rays, 0u);
}

}  // namespace
}  // namespace shprt
