// The analytic model against the clamped-cosine integral, done numerically here.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shprt/base/frame.h"
#include "shprt/sampling/hemisphere.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/bake.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

constexpr double kY00 = 0.28209479177387814;  // 1 / sqrt(4 pi)

TEST(Unshadowed, EqualsTheCosineWeightedMeanOfTheBasis) {
  Mesh mesh = test::makeIcosphere(0);
  const int degree = 6;
  const Bake bake = bakeUnshadowed(test::grey(mesh, 0.5f), degree);
  EXPECT_EQ(bake.transfer.channels, 1);
  for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    const Frame frame = frameFromNormal(normalize(toDouble(mesh.normals[vertex])));
    std::vector<double> mean(static_cast<std::size_t>(coefficientCount(degree))), y(mean.size());
    const int side = 256;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        evaluateSh(degree, frame.toWorld(sampleCosineHemisphere((i + 0.5) / side, (j + 0.5) / side)), y);
        for (std::size_t k = 0; k < y.size(); ++k) mean[k] += y[k] / (side * side);
      }
    for (std::size_t k = 0; k < y.size(); ++k) {
      EXPECT_NEAR(bake.transfer.row(0, static_cast<int>(k))[vertex], 0.5 * mean[k], 2e-4)
          << "coefficient " << k;
    }
  }
}

// A light of constant radiance 1 has the single coefficient sqrt(4 pi); with albedo 1 the surface returns 1.
TEST(Unshadowed, ReturnsTheRadianceOfAConstantLight) {
  const Mesh mesh = test::makeIcosphere(1);
  const Bake bake = bakeUnshadowed(test::grey(mesh, 1), 3);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_NEAR(bake.transfer.row(0, 0)[v] / kY00, 1, 1e-7);
}

TEST(Unshadowed, OddBandsAboveOneVanishAndColourScalesChannels) {
  const Mesh mesh = test::makeIcosphere(0);
  Scene scene = test::grey(mesh, 1);
  scene.albedo[3] = {0.25f, 0.5f, 0.75f};
  const Bake bake = bakeUnshadowed(scene, 5);
  ASSERT_EQ(bake.transfer.channels, 3);
  for (int m = -3; m <= 3; ++m) EXPECT_EQ(bake.transfer.row(1, shIndex(3, m))[3], 0);
  // y_{1,1} is sqrt(3/4pi) x, and A_1 / pi is 2/3.
  const double expected =
      2.0 / 3 * std::sqrt(3 / (4 * std::numbers::pi)) * static_cast<double>(mesh.normals[3].x);
  EXPECT_NEAR(bake.transfer.row(0, shIndex(1, 1))[3], 0.25 * expected, 1e-7);
  EXPECT_NEAR(bake.transfer.row(2, shIndex(1, 1))[3], 0.75 * expected, 1e-7);
}

}  // namespace
}  // namespace shprt
