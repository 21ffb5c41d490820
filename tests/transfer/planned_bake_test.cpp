// A bake that follows the plan agrees with a bake of everything to the error asked for, whatever the scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include "shprt/scene/load_scene.h"
#include "shprt/transfer/planned_bake.h"
#include "test_meshes.h"

namespace shprt {
namespace {

constexpr double kError = 0.01;
constexpr int kRays = 64;

// RMS over receivers and channels of the 2-norm of the difference, over that of the unshadowed transfer with
// the same albedo.
double difference(const Scene& scene, const Bake& a, const Bake& b) {
  const TransferCoefficients bare = bakeUnshadowed(scene, a.transfer.degree).transfer;
  double squares = 0, reference = 0;
  for (int channel = 0; channel < 3; ++channel)
    for (int i = 0; i < a.transfer.rows(); ++i) {
      const auto row = [&](const TransferCoefficients& t) {
        return t.row(std::min(channel, t.channels - 1), i);
      };
      for (std::uint32_t v = 0; v < a.transfer.vertexCount; ++v) {
        if (!scene.isReceiver(v)) continue;
        const double off = static_cast<double>(row(a.transfer)[v]) - static_cast<double>(row(b.transfer)[v]);
        squares += off * off;
        reference += static_cast<double>(row(bare)[v]) * static_cast<double>(row(bare)[v]);
      }
    }
  return reference > 0 ? std::sqrt(squares / reference) : 0;
}

// Returns the model that the plan chose.
std::string expectAgreement(const Scene& scene, const std::string& what) {
  const PreparedScene prepared(scene);
  const EffectPlan plan = planEffects(prepared, {}, {.rays = kRays, .error = kError});
  const Bake planned = bakeRequested(prepared, followPlan(plan, {.rays = kRays, .error = kError}));
  const Bake all = bakeRequested(prepared, {.rays = kRays, .error = kError, .traceEverything = true});
  EXPECT_LE(difference(scene, planned, all), kError) << what << ", " << plan.model;
  return plan.model;
}

Scene ofData(const std::string& file, std::optional<float> albedo = {}) {
  LoadSceneOptions options;
  if (albedo) options.albedo = Vec3f{*albedo, *albedo, *albedo};
  return loadScene(SHPRT_SOURCE_DIR "/data/" + file, options);
}

TEST(PlannedBake, AgreesWithEverythingOnOurScenes) {
  for (const char* file : {"knot.ply", "courtyard.obj", "cornell.json"}) expectAgreement(ofData(file), file);
}

// From surfaces too dark to matter to those that matter: what is skipped must be small, on both sides of the
// decision.
TEST(PlannedBake, AgreesWhereBouncesAreSkippedAndWhereTheyJustMatter) {
  int skipped = 0, kept = 0;
  for (const char* file : {"knot.ply", "courtyard.obj"})
    for (const float albedo : {0.0f, 0.01f, 0.03f, 0.05f, 0.1f, 0.3f}) {
      const std::string model =
          expectAgreement(ofData(file, albedo), std::string(file) + " " + std::to_string(albedo));
      ++(model == "interreflected" ? kept : skipped);
    }
  EXPECT_GT(skipped, 2);
  EXPECT_GT(kept, 2);
}

TEST(PlannedBake, TracesNothingWhereNothingStandsAbove) {
  const Scene sphere = test::grey(test::makeIcosphere(3), 0.8f);
  EXPECT_EQ(expectAgreement(sphere, "sphere"), "unshadowed");
}

// Colours weaker than the error are dropped, and the transfer stays within it.
TEST(PlannedBake, DropsColoursThatDoNotMatter) {
  for (const float tint : {0.002f, 0.2f}) {
    Scene scene = ofData("knot.ply", 0.6f);
    for (std::size_t v = 0; v < scene.albedo.size(); v += 2) scene.albedo[v].x += tint;
    const PreparedScene prepared(scene);
    const EffectPlan plan = planEffects(prepared, {}, {.degree = 2, .rays = kRays, .error = kError});
    EXPECT_EQ(plan.channels, tint < 0.1f ? 1 : 3);
    if (plan.channels == 3) continue;
    const BakeRequest request = followPlan(plan, {.degree = 2, .rays = kRays, .error = kError});
    Scene grey = scene;
    makeGrey(grey);
    const Bake planned = bakeRequested(PreparedScene(grey), request), all = bakeRequested(prepared, request);
    EXPECT_EQ(planned.transfer.channels, 1);
    EXPECT_EQ(all.transfer.channels, 3);
    EXPECT_LE(difference(scene, planned, all), kError);
  }
}

// A shadowed bake of a scene that emits sees its emitters, and nothing bounces.
TEST(PlannedBake, ShadowedScenesKeepTheirOwnLight) {
  Scene scene = ofData("cornell.json");
  const PreparedScene prepared(scene);
  const BakeRequest request{.model = "shadowed", .degree = 1, .rays = 16};
  const Bake shadowed = bakeRequested(prepared, request);
  ASSERT_EQ(shadowed.emission.size(), scene.mesh.positions.size());
  EXPECT_TRUE(shadowed.statistics.bounces.empty());
}

TEST(PlannedBake, BouncesThatWereAskedForStay) {
  EffectPlan plan;
  plan.model = "interreflected";
  plan.bounces = 0;
  plan.degree = 3;
  EXPECT_EQ(followPlan(plan, {}).bounces, 0);
  EXPECT_EQ(followPlan(plan, {.bounces = 5}).bounces, 5);
  plan.bounces = 4;
  EXPECT_FALSE(followPlan(plan, {}).bounces.has_value());
  EXPECT_EQ(followPlan(plan, {}).degree, 3);
}

// Every mesh of the shared data: minutes under --long, the small ones always.
TEST(PlannedBake, AgreesWithEverythingOnSharedMeshes) {
  const std::filesystem::path folder = SHPRT_SHARED_DIR "/data/meshes";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "SKIPPED: " << folder << " is absent";
#ifdef SHPRT_LONG_TESTS
  constexpr std::size_t kMostVertices = 1'000'000;
#else
  constexpr std::size_t kMostVertices = 4'000;
#endif
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string suffix = entry.path().extension().string();
    if (suffix != ".obj" && suffix != ".ply" && suffix != ".off" && suffix != ".stl" && suffix != ".STL")
      continue;
    if (kMostVertices < 1'000'000 && entry.file_size() > 400'000) continue;
    const Scene scene = loadScene(entry.path());
    if (scene.mesh.positions.size() > kMostVertices) continue;
    expectAgreement(scene, entry.path().filename().string());
    ++scenes;
  }
  EXPECT_GE(scenes, 5);
}

}  // namespace
}  // namespace shprt
