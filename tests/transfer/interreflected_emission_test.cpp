// Light that the scene sends out by itself, where it is known how much arrives.
#include <gtest/gtest.h>

#include <vector>

#include "shprt/transfer/bake.h"
#include "tests/transfer/bounce_settings.h"

namespace shprt {
namespace {

using test::makeBowlBelow;
using test::PatchBeforeWall;

// A part of a sphere fills its own fraction of every hemisphere inside it, again and again, each colour
// by its own albedo.
TEST(Interreflected, GlowingBowlIsAGeometricSeriesToo) {
  const double fraction = 0.6;
  const Mesh bowl = makeBowlBelow(2 * fraction - 1, 16, 32);
  for (const Vec3f albedo : {Vec3f{0.5f, 0.5f, 0.5f}, Vec3f{0.5f, 0.25f, 0}}) {
    Scene scene = makeScene(bowl, std::vector<Vec3f>(bowl.positions.size(), albedo));
    scene.materials[0].emission = {1, 2, 0.5f};
    const Bake bake = bakeInterreflected(scene, {.degree = 1, .rays = 512, .seed = 1, .error = 1e-3});
    EXPECT_EQ(bake.transfer.channels, albedo.y == 0.5f ? 1 : 3);
    ASSERT_EQ(bake.emission.size(), bowl.positions.size());
    for (const Vec3f& emission : bake.emission) {
      EXPECT_NEAR(emission.x, 1 / (1 - 0.5 * fraction), 0.03);
      EXPECT_NEAR(emission.y, 2 / (1 - static_cast<double>(albedo.y) * fraction), 0.06);
      EXPECT_NEAR(emission.z, 0.5 / (1 - static_cast<double>(albedo.z) * fraction), 0.02);
    }
  }
}

TEST(Interreflected, EmitterReachesAPatchByItsFormFactor) {
  PatchBeforeWall setting({0, 0, 0}, {0.5f, 0.25f, 1});
  setting.scene.materials.push_back({});
  setting.scene.materials.back().emission = {3, 2, 1};
  for (std::size_t v = PatchBeforeWall::kPatchVertices; v < setting.scene.albedo.size(); ++v)
    setting.scene.mesh.vertexMaterials[v] = 1;
  const double share = PatchBeforeWall::formFactor();
  for (const int bounces : {0, 2}) {
    const Bake bake =
        bakeInterreflected(setting.scene, {.degree = 0, .rays = 8192, .seed = 2, .bounces = bounces});
    EXPECT_NEAR(bake.emission[0].x, 0.5 * 3 * share, 2e-3);
    EXPECT_NEAR(bake.emission[0].y, 0.25 * 2 * share, 2e-3);
    EXPECT_NEAR(bake.emission[0].z, 1 * share, 2e-3);
    EXPECT_EQ(bake.emission.back(), (Vec3f{3, 2, 1}));
  }
}

// All light stays in a closed room of albedo 1: no number of bounces is enough, and the bake says so.
TEST(Interreflected, ClosedWhiteRoomConfessesWhatIsLeft) {
  Mesh room = test::makeBox({-1, -1, -1}, {2, 2, 2}, 1);
  for (Vec3f& normal : room.normals) normal = -normal;
  Scene scene = test::grey(room, 1);
  scene.materials[0].emission = {1, 1, 1};
  const Bake bake = bakeInterreflected(scene, {.degree = 0, .rays = 16});
  EXPECT_FALSE(bake.statistics.tailSummed);
  EXPECT_GT(bake.statistics.remainder, 1);
  EXPECT_EQ(bake.statistics.bounces.size(), 1000u);
  for (const Vec3f& emission : bake.emission) EXPECT_NEAR(emission.x, 1002, 1);
}

}  // namespace
}  // namespace shprt
