// Fronts, backs, and what lies inside other geometry.
#include <gtest/gtest.h>

#include <vector>

#include <cmath>
#include <numbers>

#include "shprt/transfer/bake.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

constexpr Vec3d kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

double uniformLight(const Bake& bake, std::size_t vertex) {
  return static_cast<double>(bake.transfer.row(0, 0)[vertex]) * std::sqrt(4 * std::numbers::pi);
}

enum class Sheet { kFacingUp, kFacingDown, kBothUpFirst, kBothDownFirst };

// What a small patch on the floor receives from one bounce off a sheet above it.
double bouncedBySheet(Sheet sheet, bool reverseWinding = false) {
  Mesh mesh;
  test::addPatch(mesh, {0, 0, 0}, kZ * 1e-3, kX * 1e-3);
  const auto addUp = [&] { test::addPatch(mesh, {-1, 1, -1}, kZ * 2.0, kX * 2.0, 2); };
  const auto addDown = [&] {
    // The same triangles from the other side, their corners in another order.
    test::addPatch(mesh, {-1, 1, -1}, kZ * 2.0, kX * 2.0, 2, 2, -kY);
    for (std::size_t t = mesh.triangles.size() - 8; t < mesh.triangles.size(); ++t)
      mesh.triangles[t] = {mesh.triangles[t][2], mesh.triangles[t][1], mesh.triangles[t][0]};
  };
  if (sheet == Sheet::kFacingUp || sheet == Sheet::kBothUpFirst) addUp();
  if (sheet != Sheet::kFacingUp) addDown();
  if (sheet == Sheet::kBothDownFirst) addUp();
  if (reverseWinding)
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  const Scene scene = test::grey(mesh, 1);
  const InterreflectedOptions options{.degree = 0, .rays = 512, .seed = 1, .bounces = 1};
  return uniformLight(bakeInterreflected(scene, options), 0) -
         uniformLight(bakeShadowed(scene, {.degree = 0, .rays = 512, .seed = 1}), 0);
}

TEST(InterreflectedSides, BacksReflectOnlyWhereTheSheetHasTwoSides) {
  const double down = bouncedBySheet(Sheet::kFacingDown);
  // The underside sees all of its hemisphere, and takes 55% of the patch's (a 2 x 2 square at distance 1).
  EXPECT_NEAR(down, 0.554, 5e-3);
  EXPECT_NEAR(bouncedBySheet(Sheet::kFacingUp), 0, 1e-6);
  EXPECT_NEAR(bouncedBySheet(Sheet::kBothUpFirst), down, 1e-5);
  EXPECT_NEAR(bouncedBySheet(Sheet::kBothDownFirst), down, 1e-5);
}

TEST(InterreflectedSides, NormalsDecideAndNotWinding) {
  for (const Sheet sheet : {Sheet::kFacingUp, Sheet::kFacingDown, Sheet::kBothUpFirst})
    EXPECT_NEAR(bouncedBySheet(sheet, true), bouncedBySheet(sheet), 1e-5);
}

// A two-sided sheet whose sides differ in colour: each place of the hit keeps its own. Albedo falls along x
// on the underside; the patch sees it brighter where it is nearer to the bright end.
TEST(InterreflectedSides, PlaceOnTheOppositeTriangleIsTheSame) {
  double received[2];
  for (const bool upFirst : {false, true}) {
    Mesh mesh;
    test::addPatch(mesh, {-0.9, 0, 0}, kZ * 1e-3, kX * 1e-3);
    const auto add = [&](bool up) {
      test::addPatch(mesh, {-1, 0.2, -1}, kZ * 2.0, kX * 2.0, 1, 1, up ? kY : -kY);
      for (std::size_t t = mesh.triangles.size() - 2; !up && t < mesh.triangles.size(); ++t)
        mesh.triangles[t] = {mesh.triangles[t][1], mesh.triangles[t][0], mesh.triangles[t][2]};
    };
    add(upFirst);
    add(!upFirst);
    Scene scene = test::grey(mesh, 1);
    for (std::size_t v = 4; v < scene.albedo.size(); ++v) {
      const float albedo = mesh.normals[v].y > 0 ? 0.0f : mesh.positions[v].x < 0 ? 1.0f : 0.0f;
      scene.albedo[v] = {albedo, albedo, albedo};
    }
    const InterreflectedOptions options{.degree = 0, .rays = 512, .seed = 1, .bounces = 1};
    received[upFirst] = uniformLight(bakeInterreflected(scene, options), 0) -
                        uniformLight(bakeShadowed(scene, {.degree = 0, .rays = 512, .seed = 1}), 0);
  }
  EXPECT_NEAR(received[0], received[1], 1e-5);
  EXPECT_GT(received[0], 0.3);
}

// A post stuck deep into a block. Its vertices inside the block see only backs; the lowest one that is out
// belongs to triangles that reach inside, and must not fade to black.
TEST(InterreflectedSides, BuriedVerticesTakeWhatTheirNeighboursHave) {
  Mesh mesh = test::makeBox({-0.1, -0.55, -0.1}, {0.2, 2, 0.2}, 1, 10);  // levels at -0.55, -0.35 ... 1.45
  const std::size_t post = mesh.positions.size();
  test::append(mesh, test::makeBox({-1, -2, -1}, {2, 2, 2}, 4));  // top at y = 0
  const Scene scene = test::grey(mesh, 0.5f);
  const Bake bake = bakeInterreflected(scene, {.degree = 1, .rays = 256, .seed = 1});
  const Bake shadowed = bakeShadowed(scene, {.degree = 1, .rays = 256, .seed = 1});
  std::size_t buried = 0, bottom = 0;
  for (std::size_t v = 0; v < post; ++v) {
    if (mesh.positions[v].y >= 0) continue;
    ++buried;
    if (mesh.normals[v].y < 0) {
      // The bottom face is a surface of its own, all of it inside.
      ++bottom;
      EXPECT_EQ(uniformLight(bake, v), 0);
      EXPECT_EQ(uniformLight(shadowed, v), 0);
      continue;
    }
    // The same edge or face of the post just above the block.
    EXPECT_GT(uniformLight(bake, v), 0.1);
    EXPECT_LT(uniformLight(bake, v), 0.5);
    EXPECT_GT(uniformLight(shadowed, v), 0.1);
    EXPECT_LT(uniformLight(shadowed, v), uniformLight(bake, v));
  }
  EXPECT_EQ(bottom, 4u);
  EXPECT_EQ(buried, bottom + 4 * 2 * 3);  // three levels, four faces, two corners each
  // So is the middle of the block's top, inside the post; it takes what the top has around it.
  std::size_t middle = post;
  while (mesh.positions[middle] != Vec3f{0, 0, 0}) ++middle;
  EXPECT_GT(uniformLight(shadowed, middle), 0.2);
  EXPECT_GT(uniformLight(bake, middle), 0.2);
  EXPECT_EQ(bake.statistics.buriedVertices, buried + 1);
  // Those that neighbours can fill.
  EXPECT_EQ(shadowed.statistics.buriedVertices, buried + 1 - bottom);
}

// Fits bake with an albedo of their own. What is filled has to follow it, as the rest does.
TEST(InterreflectedSides, BuriedVerticesTakeTheAlbedoAskedFor) {
  Mesh mesh = test::makeBox({-0.1, -0.55, -0.1}, {0.2, 2, 0.2}, 1, 10);
  test::append(mesh, test::makeBox({-1, -2, -1}, {2, 2, 2}, 4));
  const Scene scene = test::grey(mesh, 0.25f);
  const PreparedScene prepared(scene);
  const ShadowedOptions options{.degree = 1, .rays = 64, .seed = 1};
  const Bake own = bakeShadowed(prepared, options);
  const Bake asked =
      bakeShadowed(prepared, std::vector<Vec3f>(mesh.positions.size(), Vec3f{1, 1, 1}), options);
  ASSERT_GT(own.statistics.buriedVertices, 0u);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_FLOAT_EQ(uniformLight(asked, v), 4 * uniformLight(own, v)) << v;
}

TEST(InterreflectedSides, WhollyBuriedThingsStayBlack) {
  Mesh mesh = test::makeIcosphere(1);
  const std::size_t sphere = mesh.positions.size();
  test::append(mesh, test::makeBox({-2, -2, -2}, {4, 4, 4}, 2));
  const Bake bake = bakeInterreflected(test::grey(mesh, 0.8f), {.degree = 2, .rays = 64});
  EXPECT_EQ(bake.statistics.buriedVertices, sphere);
  for (std::size_t v = 0; v < sphere; ++v) EXPECT_EQ(uniformLight(bake, v), 0);
  for (std::size_t v = sphere; v < mesh.positions.size(); ++v) EXPECT_NEAR(uniformLight(bake, v), 0.8, 1e-6);
}

}  // namespace
}  // namespace shprt
