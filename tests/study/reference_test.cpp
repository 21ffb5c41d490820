#include "shprt/study/reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "curve_run.h"
#include "shprt/study/curve_effort.h"

namespace shprt {
namespace {

// Two floors of which one is a blocker.
Scene halfBlocked() {
  Scene scene = test::ballOverFloor();
  scene.objects.push_back(scene.objects.front());
  scene.objects.back().name = "blocker";
  scene.objects.back().role = Role::kBlocker;
  for (std::size_t v = 100; v < scene.vertexObjects.size(); ++v) scene.vertexObjects[v] = 1;
  return scene;
}

TEST(DrawVertices, GivesDistinctReceiversInOrder) {
  const Scene scene = halfBlocked();
  const std::vector<std::uint32_t> drawn = drawVertices(scene, 30, 5);
  ASSERT_EQ(drawn.size(), 30u);
  for (std::size_t i = 0; i < 30; ++i) {
    EXPECT_TRUE(scene.isReceiver(drawn[i]));
    if (i > 0) {
      EXPECT_LT(drawn[i - 1], drawn[i]);
    }
  }
  EXPECT_NE(drawn, drawVertices(scene, 30, 6));
  EXPECT_EQ(drawVertices(scene, 1000, 5), receiverVertices(scene));
}

TEST(VertexSample, BakesWhatTheWholeSceneBakes) {
  const Scene scene = test::ballOverFloor();
  const VertexSample sample(scene, drawVertices(scene, 20, 3));
  const ShadowedOptions options{.degree = 3, .rays = 50, .seed = 9};
  const TransferCoefficients expected =
      selectColumns(bakeShadowed(scene, options).transfer, sample.vertices());
  EXPECT_EQ(sample.bake(options).values, expected.values);
  EXPECT_EQ(expected.vertexCount, 20u);
}

TEST(VertexSample, LeavesTheScenesOwnLightsOut) {
  Scene lit = test::ballOverFloor();
  const ShadowedOptions options{.degree = 2, .rays = 20};
  const std::vector<float> expected = bakeShadowed(lit, options).transfer.values;
  lit.materials.front().emission = {1, 2, 3};
  EXPECT_EQ(VertexSample(lit, receiverVertices(lit)).bake(options).values, expected);
}

// Under the box the floor takes what its neighbours have; the sample has too few of those that tell.
TEST(SampleOf, LeavesOutVerticesInsideOtherGeometry) {
  Mesh mesh;
  test::addPatch(mesh, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0}, 40);
  test::append(mesh, test::makeBox({-1, -0.5, -1}, {2, 1, 2}, 8));
  test::CurveRun test(test::grey(mesh, 0.5f));
  const Scene& scene = test.run.prepared.scene;
  const VertexSample sample = sampleOf(test.run);
  const std::size_t drawn = drawVertices(scene, curveEffort(test.run.options).vertices, 1).size();
  EXPECT_LT(sample.vertices().size(), drawn);
  EXPECT_GT(sample.vertices().size(), drawn / 2);
  const ShadowedOptions options{.degree = 3, .rays = 100, .seed = 9};
  EXPECT_EQ(sample.bake(options).values,
            selectColumns(bakeShadowed(test.run.prepared, options).transfer, sample.vertices()).values);
}

TEST(ErrorMeasures, UnshadowedTransferHasTheNormThatErrorsAreRelativeTo) {
  Scene scene = test::grey(test::makeIcosphere(1), 0.5f);
  scene.albedo[3] = {0.1f, 0.9f, 0.4f};
  const TransferCoefficients transfer = bakeUnshadowed(scene, 4).transfer;
  EXPECT_NEAR(rmsNorm(transfer) / unshadowedRms(scene, receiverVertices(scene), 4), 1, 1e-6);
}

TEST(ErrorMeasures, DifferencesAddOverCoefficientsAndAverageOverVertices) {
  TransferCoefficients a{1, 1, 2, std::vector<float>(8, 1.0f)}, b = a;
  b.row(0, 2)[0] += 3;
  b.row(0, 3)[0] += 4;
  EXPECT_DOUBLE_EQ(rmsDifference(a, b), std::sqrt(25.0 / 2));
  const std::vector<Vec3f> black(2), light = {{1, 0, 0}, {0, 0, 1}}, half = {{0.5f, 0, 0}, {0, 0, 0.5f}};
  EXPECT_DOUBLE_EQ(radianceError(half, light), 0.5);
  EXPECT_EQ(radianceError(black, black), 0);
}

}  // namespace
}  // namespace shprt
