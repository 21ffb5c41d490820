// What a plan calls for in scenes whose effects are known.
#include "shprt/transfer/effect_plan.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "shprt/base/parallel.h"
#include "shprt/coefficients/asset_file.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/band_tails.h"
#include "tests/scratch.h"
#include "tests/transfer/bowl.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

constexpr Vec3f kGrey{0.8f, 0.8f, 0.8f}, kRed{0.8f, 0.2f, 0.2f};

std::vector<std::string> neededIn(const EffectPlan& plan) {
  std::vector<std::string> needed;
  for (const EffectFinding& finding : plan.findings) {
    if (finding.needed) needed.push_back(finding.effect);
  }
  return needed;
}

LightCoefficients lightOf(std::vector<double> values) {
  LightCoefficients light;
  while (coefficientCount(light.degree) < static_cast<int>(values.size())) ++light.degree;
  values.resize(static_cast<std::size_t>(coefficientCount(light.degree)));
  for (const double value : values) light.coefficients.push_back({value, value, value});
  return light;
}

using Names = std::vector<std::string>;

TEST(EffectPlan, ConvexGreyScenesCallForNothingButTheirDegree) {
  for (const Mesh& mesh : {test::makeIcosphere(2), test::makeBox({-1, 2, 3}, {1, 2, 3}, 3)}) {
    const EffectPlan plan = planEffects(test::grey(mesh, 0.8f), {}, {});
    EXPECT_EQ(neededIn(plan), Names{"degree"});
    EXPECT_EQ(plan.model, "unshadowed");
    EXPECT_EQ(plan.channels, 1);
    EXPECT_EQ(plan.finding("shadows").seconds, 0);
    EXPECT_EQ(plan.finding("interreflection").contribution.high, 0);
  }
}

TEST(EffectPlan, BlackScenesHaveShadowsAndNoBounces) {
  const EffectPlan plan = planEffects(test::paintedBowl(0.5, {}), {}, {});
  EXPECT_EQ(neededIn(plan), (Names{"shadows", "degree"}));
  EXPECT_EQ(plan.model, "shadowed");
  EXPECT_EQ(plan.bounces, 0);
  EXPECT_EQ(plan.finding("interreflection").evidence, "nothing reflects");
}

// What bounces add in a bowl is (1-f) rho f / (1 - rho f): 0.33 at f = 1/2, albedo 0.8.
TEST(EffectPlan, BouncesAreCalledForAboveTheErrorOnly) {
  const Scene scene = test::paintedBowl(0.5, kGrey);
  const EffectPlan fine = planEffects(scene, {}, {.error = 0.01});
  EXPECT_EQ(neededIn(fine), (Names{"shadows", "interreflection", "degree"}));
  EXPECT_EQ(fine.model, "interreflected");
  // 0.333 * 0.4^k <= 0.01 from k = 4.
  EXPECT_NEAR(fine.bounces, 4, 1);
  EXPECT_GE(fine.finding("interreflection").seconds, 0);
  for (const EffectFinding& finding : fine.findings) EXPECT_EQ(finding.simulated, finding.needed);
  EXPECT_EQ(planEffects(scene, {}, {.error = 0.5}).model, "shadowed");
}

TEST(EffectPlan, OneChannelWhereNothingHasColour) {
  EXPECT_EQ(planEffects(test::paintedBowl(0.5, kGrey), {}, {}).channels, 1);
  const EffectPlan red = planEffects(test::paintedBowl(0.5, kRed), {}, {});
  EXPECT_EQ(red.channels, 3);
  EXPECT_TRUE(red.finding("colour").needed);
  // Colour that no eye would find at this error.
  EXPECT_EQ(planEffects(test::paintedBowl(0.5, {0.8f, 0.8f, 0.8001f}), {}, {}).channels, 1);
}

// A grey floor is coloured by a red wall, even when the wall is no receiver.
TEST(EffectPlan, ColourBleedsOntoGreyReceivers) {
  Mesh mesh;
  test::addPatch(mesh, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 8);
  const std::size_t floor = mesh.positions.size();
  test::addPatch(mesh, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 8);
  std::vector<Vec3f> albedo(mesh.positions.size(), kRed);
  std::fill_n(albedo.begin(), floor, kGrey);
  Scene scene = makeScene(mesh, albedo);
  scene.objects.push_back({"wall", "", Role::kBlocker, {}});
  std::fill(scene.vertexObjects.begin() + static_cast<std::ptrdiff_t>(floor), scene.vertexObjects.end(), 1u);
  const EffectPlan plan = planEffects(scene, {}, {});
  EXPECT_EQ(plan.vertices, floor);
  EXPECT_EQ(plan.channels, 3);
  EXPECT_GT(plan.finding("colour").contribution.value, 0.01);
}

TEST(EffectPlan, LightOfTheSceneItselfIsBaked) {
  Scene scene = test::paintedBowl(0.5, kGrey);
  scene.materials[0].emission = {1, 1, 1};
  const EffectPlan plan = planEffects(scene, {}, {.error = 0.5});
  EXPECT_TRUE(plan.finding("emission").needed);
  EXPECT_EQ(plan.model, "interreflected");
  EXPECT_GE(plan.bounces, 1);  // though what comes from the sky is within the error

  // A room without a window, lit from inside: nothing comes from the sky, and light bounces all the same.
  Mesh room = test::makeBox({-1, -1, -1}, {2, 2, 2}, 2);
  for (Vec3f& normal : room.normals) normal = -normal;
  for (Triangle& triangle : room.triangles) std::swap(triangle[1], triangle[2]);
  for (const float albedo : {0.8f, 0.0f}) {
    Scene closed = test::grey(room, albedo);
    closed.materials[0].emission = {1, 1, 1};
    const EffectPlan inside = planEffects(closed, {}, {});
    EXPECT_EQ(inside.finding("interreflection").needed, albedo > 0);
    EXPECT_EQ(inside.model, "interreflected");  // the one that knows emission, if with no bounce
    EXPECT_EQ(inside.bounces > 0, albedo > 0);
  }

  // A lamp below a floor that faces up lights nothing.
  Mesh mesh;
  test::addPatch(mesh, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 4);
  test::addPatch(mesh, {0, -1, 0}, {0, 0, 1}, {1, 0, 0}, 1);
  Scene below = test::grey(mesh, 0.8f);
  below.materials.emplace_back();
  below.materials.back().emission = {5, 5, 5};
  below.objects.push_back({"lamp", "", Role::kBlocker, {}});
  for (std::size_t v = 25; v < mesh.positions.size(); ++v)
    below.mesh.vertexMaterials[v] = below.vertexObjects[v] = 1;
  EXPECT_EQ(neededIn(planEffects(below, {}, {})), Names{"degree"});
}

TEST(EffectPlan, GlossAndTranslucencyAreReportedAsNotSimulated) {
  Scene scene = test::grey(test::makeBox({0, 0, 0}, {1, 1, 1}, 2), 0.6f);
  scene.materials[0].gloss = Gloss{{0.2f, 0.2f, 0.2f}, 0.1f};
  scene.materials[0].translucency = Translucency{{0.3f, 0.3f, 0.3f}, 1};
  const EffectPlan plan = planEffects(scene, {}, {});
  const EffectFinding &glossy = plan.finding("glossy"), &translucency = plan.finding("translucency");
  EXPECT_TRUE(glossy.needed);
  EXPECT_FALSE(glossy.simulated);
  EXPECT_NEAR(glossy.contribution.value, 0.2 / 0.8, 1e-6);
  EXPECT_TRUE(translucency.needed);
  EXPECT_FALSE(translucency.simulated);
  EXPECT_NEAR(translucency.contribution.value, 0.3 / 0.9, 1e-6);
}

// Bands that the light does not have cannot matter; those it has do when the error is small.
TEST(EffectPlan, TheDegreeFollowsTheLight) {
  const Scene scene = test::paintedBowl(0.5, kGrey);
  const PlanOptions options{.degree = {}, .error = 1e-4};
  EXPECT_EQ(planEffects(scene, std::vector{lightOf({1})}, options).degree, 0);
  EXPECT_EQ(planEffects(scene, std::vector{lightOf({1, 0, 0, 0, 0, 0, 0.5})}, options).degree, 2);
  EXPECT_EQ(planEffects(scene, {}, options).degree, 4);
  PlanOptions asked = options;
  asked.degree = 6;
  EXPECT_EQ(planEffects(scene, std::vector{lightOf({1})}, asked).degree, 6);
}

TEST(BandTails, AreWhatIsLeftOutOfKnownEnergies) {
  const std::vector<double> tails = tailShares(std::vector<double>{9, 4, 3, 0});
  EXPECT_DOUBLE_EQ(tails[0], std::sqrt(7.0 / 16));
  EXPECT_DOUBLE_EQ(tails[1], std::sqrt(3.0 / 16));
  EXPECT_EQ(tails[2], 0);
  EXPECT_EQ(tails[3], 0);
  const std::vector<double> both = radianceBandEnergy(std::vector<double>{2, 3}, std::vector<double>{5, 7});
  EXPECT_DOUBLE_EQ(both[0], 10);
  EXPECT_DOUBLE_EQ(both[1], 7);
  // Lights add up before they are squared: opposite ones leave only what they share.
  const std::vector<LightCoefficients> lights = {lightOf({1, 2, 0, 0}), lightOf({1, -2, 0, 0})};
  EXPECT_EQ(lightBandEnergy(lights, 2), (std::vector<double>{4, 0, 0}));
}

TEST(EffectPlan, PredictsTheBytesOfTheAsset) {
  for (const Vec3f albedo : {kGrey, kRed})
    for (const bool half : {false, true}) {
      const Scene scene = test::paintedBowl(0.5, albedo);
      const EffectPlan plan = planEffects(scene, {}, {.half = half});
      TransferAsset asset;
      asset.transfer = bakeShadowed(scene, {.degree = plan.degree, .rays = 16}).transfer;
      asset.positions = scene.mesh.positions;
      asset.normals = scene.mesh.normals;
      asset.albedo = scene.albedo;
      asset.triangles = scene.mesh.triangles;
      const std::string path = test::scratch("bowl.prt.exr");
      writeAsset(path, asset, {.half = half});
      const auto written = static_cast<double>(std::filesystem::file_size(path));
      EXPECT_NEAR(static_cast<double>(plan.bytes), written, 0.02 * written + 4096);
    }
}

TEST(EffectPlan, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = test::paintedBowl(0.6, kRed);
  setThreadCount(1);
  const EffectPlan one = planEffects(scene, {}, {.seed = 9});
  setThreadCount(2);
  const EffectPlan two = planEffects(scene, {}, {.seed = 9});
  setThreadCount(0);
  ASSERT_EQ(one.findings.size(), two.findings.size());
  for (std::size_t i = 0; i < one.findings.size(); ++i) {
    EXPECT_EQ(one.findings[i].evidence, two.findings[i].evidence);
    EXPECT_EQ(one.findings[i].contribution.high, two.findings[i].contribution.high);
  }
  EXPECT_EQ(one.bounces, two.bounces);
}

}  // namespace
}  // namespace shprt
