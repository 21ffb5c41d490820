// Light that bounces, where closed forms, symmetry or another model tell the answer.
#include <gtest/gtest.h>

#include <numbers>

#include <algorithm>
#include <cmath>
#include <vector>

#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/transfer_rows.h"
#include "tests/transfer/bounce_settings.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

using test::makeBowlBelow;
using test::PatchBeforeWall;
using test::uniformLight;

constexpr Vec3d kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

double largestDifference(const TransferCoefficients& a, const TransferCoefficients& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    largest = std::max(largest, static_cast<double>(std::abs(a.values[i] - b.values[i])));
  return largest;
}

Mesh twoSpheresInABowl() {
  Mesh mesh = makeBowlBelow(0.2, 8, 16);
  test::append(mesh, test::moved(test::makeIcosphere(2), 0.3, {0.2, -0.5, 0}));
  test::append(mesh, test::moved(test::makeIcosphere(1), 0.2, {-0.4, -0.2, 0.1}));
  return mesh;
}

TEST(Interreflected, WithoutBouncesIsShadowedTransfer) {
  const Scene scene = test::grey(twoSpheresInABowl(), 0.7f);
  const Bake shadowed = bakeShadowed(scene, {.degree = 4, .rays = 200, .seed = 5});
  const Bake bounced = bakeInterreflected(scene, {.degree = 4, .rays = 200, .seed = 5, .bounces = 0});
  ASSERT_EQ(bounced.transfer.channels, 1);
  ASSERT_EQ(bounced.transfer.values.size(), shadowed.transfer.values.size());
  EXPECT_LE(largestDifference(bounced.transfer, shadowed.transfer), 1e-7);
  EXPECT_EQ(bounced.statistics.fullyVisible, shadowed.statistics.fullyVisible);
  EXPECT_EQ(bounced.statistics.fullyHidden, shadowed.statistics.fullyHidden);
  EXPECT_EQ(bounced.statistics.meanVisibility, shadowed.statistics.meanVisibility);
  EXPECT_EQ(bounced.statistics.samplePoints, shadowed.statistics.samplePoints);
  EXPECT_TRUE(bounced.statistics.bounces.empty());
}

// The wall sees everything, so it sends back its albedo times its unshadowed transfer, and the patch receives
// that from the share that the wall takes.
TEST(Interreflected, OneBounceOffAWallIsItsFormFactorTimesItsUnshadowedTransfer) {
  const PatchBeforeWall setting({0.6f, 0.6f, 0.6f});
  const InterreflectedOptions options{.degree = 4, .rays = 8192, .seed = 1, .bounces = 1};
  const Bake bounced = bakeInterreflected(setting.scene, options);
  const Bake shadowed = bakeShadowed(setting.scene, {.degree = 4, .rays = 8192, .seed = 1});
  std::vector<double> wall(static_cast<std::size_t>(coefficientCount(4)));
  UnshadowedTransfer(4).evaluate(kX, wall);
  const double share = PatchBeforeWall::formFactor();
  for (std::size_t vertex = 0; vertex < PatchBeforeWall::kPatchVertices; ++vertex)
    for (std::size_t k = 0; k < wall.size(); ++k) {
      const auto i = static_cast<int>(k);
      const double added = static_cast<double>(bounced.transfer.row(0, i)[vertex]) -
                           static_cast<double>(shadowed.transfer.row(0, i)[vertex]);
      EXPECT_NEAR(added, 0.6 * share * wall[k], 5e-4) << k;
    }
  ASSERT_EQ(bounced.statistics.bounces.size(), 1u);
}

// Inside a sphere every point sees every other under the same share of its hemisphere, so bounces are a
// geometric series of ratio albedo times the bowl's fraction of the sphere. The mesh of chords is a bowl of
// its own: its share is what its visibility says.
TEST(Interreflected, BowlUnderAUniformSkyIsAGeometricSeries) {
  const double fraction = 0.6, albedo = 0.8;
  const Mesh bowl = makeBowlBelow(2 * fraction - 1, 24, 48);
  const Scene scene = test::grey(bowl, static_cast<float>(albedo));
  for (const int bounces : {0, 1, 3, -1}) {
    InterreflectedOptions options{.degree = 0, .rays = 256, .seed = 1, .error = 1e-3};
    if (bounces >= 0) options.bounces = bounces;
    const Bake bake = bakeInterreflected(scene, options);
    const double ratio = albedo * fraction;
    const double series = bounces < 0 ? 1 / (1 - ratio) : (1 - std::pow(ratio, bounces + 1)) / (1 - ratio);
    double mean = 0;
    for (std::size_t vertex = 0; vertex < bowl.positions.size(); ++vertex) {
      EXPECT_NEAR(uniformLight(bake, vertex) / albedo, (1 - fraction) * series, 0.02 * series) << bounces;
      mean += uniformLight(bake, vertex) / albedo / static_cast<double>(bowl.positions.size());
    }
    EXPECT_NEAR(mean, (1 - fraction) * series, 0.004 * series) << bounces;
    if (bounces < 0) {
      EXPECT_TRUE(bake.statistics.tailSummed);
      EXPECT_NEAR(bake.statistics.spectralRadius, ratio, 0.01);
      EXPECT_LE(bake.statistics.remainder, 1e-3);
    }
    for (std::size_t k = 0; k < bake.statistics.bounces.size(); ++k) {
      EXPECT_NEAR(bake.statistics.bounces[k].norm, (1 - fraction) * std::pow(ratio, k + 1), 5e-3);
    }
  }
}

// A floor vertex at the foot of a wall sees the wall at its foot, and that foot sees the floor's. Both have
// the same visible share a of their sky, so each receives a / (1 - albedo (1 - a)). A back of the wall, first
// or last in the file, changes nothing.
TEST(Interreflected, FloorAtTheFootOfAWallSeesTheWallAtItsFoot) {
  enum { kNoBack, kBackFirst, kBackLast };
  for (const int back : {kNoBack, kBackFirst, kBackLast}) {
    Mesh corner;
    test::addPatch(corner, {0, 0, -1}, kZ * 2.0, kX, 2);
    const auto addBack = [&] { test::addPatch(corner, {0, 0, -1}, kZ * 2.0, kY, 2); };
    if (back == kBackFirst) addBack();
    const std::size_t floor = 3, wall = corner.positions.size() + 1;
    test::addPatch(corner, {0, 0, -1}, kY, kZ * 2.0, 2);
    if (back == kBackLast) addBack();
    ASSERT_EQ(corner.positions[floor], corner.positions[wall]);
    const double albedo = 0.8;
    const Bake bake = bakeInterreflected(test::grey(corner, static_cast<float>(albedo)),
                                         {.degree = 0, .rays = 4096, .seed = 1, .bounces = 30});
    for (const std::size_t vertex : {floor, wall}) {
      EXPECT_NEAR(uniformLight(bake, vertex) / albedo, 0.5 / (1 - albedo * 0.5), 5e-3) << back;
    }
  }
}

TEST(Interreflected, ConvexAndBlackSurfacesGetNothing) {
  const Mesh sphere = test::makeIcosphere(2);
  const Bake convex = bakeInterreflected(test::grey(sphere, 0.9f), {.degree = 3, .rays = 64});
  const Bake convexShadowed = bakeShadowed(test::grey(sphere, 0.9f), {.degree = 3, .rays = 64});
  EXPECT_LE(largestDifference(convex.transfer, convexShadowed.transfer), 1e-7);
  EXPECT_EQ(convex.statistics.hits, 0u);
  EXPECT_EQ(convex.statistics.remainder, 0);

  // White receivers around black ones: what is black sends nothing back.
  Mesh mesh = twoSpheresInABowl();
  Scene scene = test::grey(mesh, 0);
  std::fill_n(scene.albedo.end() - 42, 42, Vec3f{1, 1, 1});  // the smaller sphere, which is convex
  const Bake dark = bakeInterreflected(scene, {.degree = 3, .rays = 64});
  const Bake darkShadowed = bakeShadowed(scene, {.degree = 3, .rays = 64});
  for (std::size_t v = mesh.positions.size() - 42; v < mesh.positions.size(); ++v)
    EXPECT_NEAR(dark.transfer.row(0, 0)[v], darkShadowed.transfer.row(0, 0)[v], 1e-7);
}

TEST(Interreflected, ColourBleedsOnlyFromWhatHasIt) {
  const PatchBeforeWall setting({0.9f, 0, 0});
  const Bake bounced = bakeInterreflected(setting.scene, {.degree = 2, .rays = 256, .bounces = 2});
  const Bake shadowed = bakeShadowed(setting.scene, {.degree = 2, .rays = 256});
  ASSERT_EQ(bounced.transfer.channels, 3);
  EXPECT_GT(uniformLight(bounced, 0, 0), uniformLight(shadowed, 0, 0) + 0.05);
  for (const int channel : {1, 2})
    for (int k = 0; k < bounced.transfer.rows(); ++k)
      EXPECT_NEAR(bounced.transfer.row(channel, k)[0], shadowed.transfer.row(channel, k)[0], 1e-7);
}

// The wall's texture is red on the half nearer to its foot's row and blue above; its vertices are said to be
// black, which hits must not believe.
TEST(Interreflected, TexturesAreLookedUpWhereRaysEnd) {
  PatchBeforeWall setting({0, 0, 0});
  Scene& scene = setting.scene;
  Image texture;
  texture.width = 1, texture.height = 64;
  texture.pixels.resize(64);
  for (int y = 0; y < 64; ++y) texture.at(0, y) = y < 32 ? Vec3f{0, 0, 0.5f} : Vec3f{0.5f, 0, 0};
  scene.textures.push_back(texture);
  scene.materials.push_back({});
  scene.materials.back().texture = 0;
  scene.mesh.textureCoordinates.resize(scene.mesh.positions.size());
  for (std::size_t v = PatchBeforeWall::kPatchVertices; v < scene.albedo.size(); ++v) {
    scene.mesh.vertexMaterials[v] = 1;
    scene.mesh.textureCoordinates[v] = {0.5f, scene.mesh.positions[v].y};
  }
  const InterreflectedOptions options{.degree = 0, .rays = 8192, .seed = 1, .bounces = 1};
  const Bake bounced = bakeInterreflected(scene, options);
  ASSERT_EQ(bounced.transfer.channels, 3);
  const double sky = 1 - PatchBeforeWall::formFactor();
  const double low = PatchBeforeWall::formFactor(0, 0.5), high = PatchBeforeWall::formFactor(0.5, 1);
  EXPECT_NEAR(uniformLight(bounced, 0, 0), sky + 0.5 * low, 3e-3);
  EXPECT_NEAR(uniformLight(bounced, 0, 1), sky, 3e-3);
  EXPECT_NEAR(uniformLight(bounced, 0, 2), sky + 0.5 * high, 3e-3);
  InterreflectedOptions retraced = options;
  retraced.hitMemory = 0;
  EXPECT_EQ(bakeInterreflected(scene, retraced).transfer.values, bounced.transfer.values);
}

TEST(Interreflected, BitsDependNeitherOnThreadsNorOnMemory) {
  Scene scene = test::grey(twoSpheresInABowl(), 0.7f);
  scene.albedo[3] = {0.2f, 0.5f, 0.9f};
  scene.materials[0].emission = {0.1f, 0, 0.3f};
  InterreflectedOptions options{.degree = 4, .rays = 100, .seed = 11};
  setThreadCount(1);
  const Bake one = bakeInterreflected(scene, options);
  setThreadCount(2);
  const Bake two = bakeInterreflected(scene, options);
  options.hitMemory = 0;
  const Bake retraced = bakeInterreflected(scene, options);
  options.hitMemory = one.statistics.hitBytes / 2;
  const Bake half = bakeInterreflected(scene, options);
  setThreadCount(0);
  for (const Bake* other : {&two, &retraced, &half}) {
    EXPECT_EQ(one.transfer.values, other->transfer.values);
    EXPECT_EQ(one.emission, other->emission);
    EXPECT_EQ(one.statistics.remainder, other->statistics.remainder);
  }
  EXPECT_EQ(one.statistics.retracedPoints, 0u);
  EXPECT_EQ(retraced.statistics.hitBytes, 0u);
  EXPECT_EQ(retraced.statistics.retracedPoints, one.statistics.samplePoints);
  EXPECT_LE(half.statistics.hitBytes, options.hitMemory);
  EXPECT_GT(half.statistics.retracedPoints, 0u);
}

// Rays are fixed by the number of a vertex, so that another order is another sample of the same light.
TEST(Interreflected, OrderOfVerticesDoesNotMatter) {
  const Mesh mesh = twoSpheresInABowl();
  const std::size_t count = mesh.positions.size();
  Mesh reversed = mesh;
  std::reverse(reversed.positions.begin(), reversed.positions.end());
  std::reverse(reversed.normals.begin(), reversed.normals.end());
  std::reverse(reversed.triangles.begin(), reversed.triangles.end());
  for (Triangle& triangle : reversed.triangles)
    for (std::uint32_t& corner : triangle) corner = static_cast<std::uint32_t>(count) - 1 - corner;
  const InterreflectedOptions options{.degree = 2, .rays = 1024, .bounces = 1};
  const Bake forward = bakeInterreflected(test::grey(mesh, 0.8f), options);
  const Bake backward = bakeInterreflected(test::grey(reversed, 0.8f), options);
  double squares = 0;
  for (std::size_t v = 0; v < count; ++v)
    squares += std::pow(uniformLight(forward, v) - uniformLight(backward, count - 1 - v), 2);
  EXPECT_LE(std::sqrt(squares / static_cast<double>(count)), 4e-3);
}

TEST(Interreflected, BlockersReflectAndAreNotBaked) {
  PatchBeforeWall setting({0.6f, 0.6f, 0.6f});
  const Bake open = bakeInterreflected(setting.scene, {.degree = 2, .rays = 256});
  setting.scene.objects.emplace_back();
  setting.scene.objects.back().role = Role::kBlocker;
  for (std::size_t v = PatchBeforeWall::kPatchVertices; v < setting.scene.albedo.size(); ++v)
    setting.scene.vertexObjects[v] = 1;
  const Bake blocked = bakeInterreflected(setting.scene, {.degree = 2, .rays = 256});
  for (int k = 0; k < blocked.transfer.rows(); ++k) {
    EXPECT_NEAR(blocked.transfer.row(0, k)[0], open.transfer.row(0, k)[0], 1e-4);
    for (std::size_t v = PatchBeforeWall::kPatchVertices; v < setting.scene.albedo.size(); ++v)
      ASSERT_EQ(blocked.transfer.row(0, k)[v], 0);
  }
  EXPECT_EQ(blocked.statistics.samplePoints, PatchBeforeWall::kPatchVertices);
}

TEST(Interreflected, ReportsProgressToTheEnd) {
  ProgressReport last;
  const Scene scene = test::grey(twoSpheresInABowl(), 0.7f);
  const Bake bake = bakeInterreflected(scene, {.degree = 1, .rays = 16, .bounces = 4}, [&](auto& report) {
    EXPECT_GE(report.done, last.done);
    last = report;
  });
  EXPECT_EQ(last.done, last.total);
  EXPECT_EQ(last.rays, bake.statistics.rays);
  EXPECT_EQ(bake.statistics.bounces.size(), 4u);
}

// Two boxes, one on the other, of albedo 1: what auto adds as a geometric series may not lift any vertex
// above what it would have without any shadow.
TEST(Interreflected, TailAddsNoEnergy) {
  Mesh mesh = test::makeBox({-1, 0, -1}, {2, 1, 2}, 4);
  test::append(mesh, test::makeBox({-0.4, 1, -0.4}, {0.8, 1, 0.8}, 4));
  Mesh floor;
  test::addPatch(floor, {-3, 0, -3}, {0, 0, 6}, {6, 0, 0}, 12);
  test::append(mesh, floor);
  const Bake bake = bakeInterreflected(test::grey(mesh, 1), {.degree = 1, .rays = 64, .error = 0.05});
  ASSERT_TRUE(bake.statistics.tailSummed);
  const float most = static_cast<float>(std::numbers::inv_sqrtpi / 2) * 1.000001f;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) EXPECT_LE(bake.transfer.row(0, 0)[v], most) << v;
}

}  // namespace
}  // namespace shprt
