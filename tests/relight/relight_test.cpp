// Relighting is a dot product per vertex, colour by colour, over the bands that both sides have.
#include <gtest/gtest.h>

#include <cmath>

#include "shprt/base/parallel.h"
#include "shprt/relight/relight.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

TransferCoefficients makeTransfer(int degree, int channels, std::size_t vertices) {
  TransferCoefficients transfer;
  transfer.degree = degree;
  transfer.channels = channels;
  transfer.vertexCount = vertices;
  transfer.values.resize(static_cast<std::size_t>(channels) *
                         static_cast<std::size_t>(coefficientCount(degree)) * vertices);
  for (std::size_t i = 0; i < transfer.values.size(); ++i)
    transfer.values[i] = static_cast<float>(std::sin(0.7 * double(i) + 0.3));
  return transfer;
}

LightCoefficients makeLight(int degree) {
  LightCoefficients light;
  light.degree = degree;
  for (int i = 0; i < coefficientCount(degree); ++i)
    light.coefficients.push_back({std::cos(i), 2 * std::cos(3.1 * i), -std::cos(5.3 * i)});
  return light;
}

TEST(Relight, IsTheDotProductOfEachVertex) {
  for (const int channels : {1, 3})
    for (const int degree : {0, 1, 4, 7})
      for (const std::size_t vertices : {1u, 2047u, 2048u, 5000u}) {
        const TransferCoefficients transfer = makeTransfer(degree, channels, vertices);
        const LightCoefficients light = makeLight(degree);
        const std::vector<Vec3f> radiance = relight(transfer, light);
        ASSERT_EQ(radiance.size(), vertices);
        for (const std::size_t v : {std::size_t{0}, vertices / 2, vertices - 1}) {
          double expected[3] = {};
          for (int i = 0; i < coefficientCount(degree); ++i)
            for (int c = 0; c < 3; ++c) {
              expected[c] += double(transfer.row(channels == 1 ? 0 : c, i)[v]) *
                             light.coefficients[size_t(i)][size_t(c)];
            }
          EXPECT_NEAR(radiance[v].x, expected[0], 1e-5);
          EXPECT_NEAR(radiance[v].y, expected[1], 1e-5);
          EXPECT_NEAR(radiance[v].z, expected[2], 1e-5);
        }
      }
}

TEST(Relight, UsesTheBandsThatBothHave) {
  const TransferCoefficients transfer = makeTransfer(4, 1, 10);
  LightCoefficients longer = makeLight(6), shorter = makeLight(4);
  for (std::size_t i = 0; i < 25; ++i) shorter.coefficients[i] = longer.coefficients[i];
  EXPECT_EQ(relight(transfer, longer), relight(transfer, shorter));
  EXPECT_EQ(relight(makeTransfer(2, 1, 10), makeLight(0)).size(), 10u);
}

// A bright sun in one coefficient and its cancelling rest: sums in float would lose the small remainder.
TEST(Relight, SumsInDouble) {
  TransferCoefficients transfer = makeTransfer(1, 1, 1);
  transfer.values = {1, 1, 1, 1};
  LightCoefficients light = makeLight(1);
  light.coefficients = {{1e9, 0, 0}, {0.125, 0, 0}, {-1e9, 0, 0}, {0.25, 0, 0}};
  EXPECT_EQ(relight(transfer, light)[0].x, 0.375f);
}

TEST(Relight, GivesTheSameBitsForAnyNumberOfThreads) {
  const TransferCoefficients transfer = makeTransfer(4, 3, 9000);
  const LightCoefficients light = makeLight(4);
  setThreadCount(1);
  const std::vector<Vec3f> one = relight(transfer, light);
  setThreadCount(2);
  EXPECT_EQ(one, relight(transfer, light));
  setThreadCount(0);
}

TransferAsset makeEmitter() {
  TransferAsset asset;
  asset.transfer = makeTransfer(2, 3, 3000);
  for (std::size_t v = 0; v < 3000; ++v) asset.emission.push_back({static_cast<float>(v), 0.25f, 0});
  return asset;
}

TEST(RelightWithEmission, AddsItScaled) {
  const TransferAsset asset = makeEmitter();
  const LightCoefficients light = makeLight(2);
  const std::vector<Vec3f> reflected = relight(asset.transfer, light);
  for (const double scale : {0.0, 1.0, 2.5}) {
    const std::vector<Vec3f> radiance = relight(asset, light, scale);
    for (std::size_t v = 0; v < radiance.size(); v += 7) {
      EXPECT_NEAR(radiance[v].x, reflected[v].x + scale * double(v), 1e-7 * (1 + scale * double(v)));
      EXPECT_NEAR(radiance[v].y, reflected[v].y + scale * 0.25, 1e-6);
      EXPECT_EQ(radiance[v].z, reflected[v].z);
    }
  }
}

TEST(RelightWithEmission, StandsAloneUnderBlackLight) {
  TransferAsset asset = makeEmitter();
  const LightCoefficients black{.degree = 0, .coefficients = {{0, 0, 0}}, .source = "", .statisticsJson = ""};
  EXPECT_EQ(relight(asset, black, 1), asset.emission);
  EXPECT_EQ(relight(asset, black, 0), std::vector<Vec3f>(3000));
  asset.emission.clear();
  EXPECT_EQ(relight(asset, makeLight(2), 5), relight(asset.transfer, makeLight(2)));
}

}  // namespace
}  // namespace shprt
