// Figures of assets whose transfer is known in closed form.
#include "shprt/report/asset_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace shprt {
namespace {

using std::numbers::pi;

// Vertices that see the shares 1, 1/2 and 1/4 of the sky, as far as band 0 goes, and one that is black; band
// 1 holds 0.1 along y in every vertex.
TransferAsset makeAsset(int channels) {
  TransferAsset asset;
  asset.transfer = {.degree = 1, .channels = channels, .vertexCount = 4, .values = {}};
  asset.transfer.values.resize(static_cast<std::size_t>(channels) * 16);
  asset.albedo = {{0.5f, 0.25f, 0.125f}, {0.5f, 0.25f, 0.125f}, {0.5f, 0.25f, 0.125f}, {0, 0, 0}};
  const double shares[] = {1, 0.5, 0.25, 0};
  for (int channel = 0; channel < channels; ++channel)
    for (std::size_t v = 0; v < 4; ++v) {
      const double albedo = 0.5 / (1 << channel);
      asset.transfer.row(channel, 0)[v] = static_cast<float>(albedo * shares[v] / std::sqrt(4 * pi));
      asset.transfer.row(channel, 1)[v] = v == 2 ? -0.1f : 0.1f;
    }
  return asset;
}

TEST(AssetStatistics, MeasureByDefinition) {
  for (const int channels : {1, 3}) {
    const AssetStatistics statistics = measureAsset(makeAsset(channels));
    EXPECT_EQ(statistics.minimum, -0.1f);
    EXPECT_EQ(statistics.maximum, static_cast<float>(0.5 / std::sqrt(4 * pi)));
    EXPECT_NEAR(statistics.meanVisibility, 1.75 / 3, 1e-7);  // the black vertex tells nothing
    EXPECT_NEAR(statistics.minimumVisibility, 0.25, 1e-7);
    EXPECT_NEAR(statistics.maximumVisibility, 1, 1e-7);
    ASSERT_EQ(statistics.bandEnergy.size(), 2u);
    const double albedoSquares = channels == 1 ? 0.25 : (0.25 + 0.0625 + 0.015625) / 3;
    EXPECT_NEAR(statistics.bandEnergy[0], albedoSquares * 1.3125 / 4 / (4 * pi), 1e-8);
    EXPECT_NEAR(statistics.bandEnergy[1], 0.01, 1e-8);
  }
}

TEST(AssetStatistics, BlackSurfacesHaveNoVisibility) {
  TransferAsset asset = makeAsset(1);
  for (Vec3f& albedo : asset.albedo) albedo = {};
  EXPECT_EQ(measureAsset(asset).meanVisibility, 0);
  EXPECT_EQ(measureAsset(TransferAsset{}).bandEnergy.size(), 0u);
}

TEST(AssetStatistics, MeasureEmission) {
  TransferAsset asset = makeAsset(1);
  EXPECT_EQ(measureAsset(asset).maximumEmission, 0);
  EXPECT_EQ(measureAsset(asset).emissionShare, 0);
  asset.emission = {{2, 0.5f, 0.5f}, {0, 0, 0}, {1, 1, 15}, {0.25f, 0.25f, 0.25f}};
  EXPECT_EQ(measureAsset(asset).minimumEmission, 0);
  EXPECT_EQ(measureAsset(asset).maximumEmission, 15);
  EXPECT_EQ(measureAsset(asset).emissionShare, 0.75);
  asset.emission.assign(4, {3, 4, 5});
  EXPECT_EQ(measureAsset(asset).minimumEmission, 3);
  EXPECT_EQ(measureAsset(asset).emissionShare, 1);
}

// Unshadowed transfer of degree 1 and albedo a has the squared norm a^2 (1/(4 pi) + 1/(3 pi)): from y_00, and
// (A_1/pi)^2 3/(4 pi) with A_1 = 2 pi/3.
TEST(AssetStatistics, MeasureStandardErrors) {
  for (const int channels : {1, 3}) {
    TransferAsset asset = makeAsset(channels);
    EXPECT_LT(measureAsset(asset).transferError, 0);
    asset.albedo.assign(4, {0.5f, 0.5f, 0.5f});
    asset.albedo[3] = {};
    asset.error = {.degree = 1, .channels = channels, .vertexCount = 4, .values = {}};
    for (int channel = 0; channel < channels; ++channel)
      for (const float value : {0.03f, 0.f, 0.f, 0.f, 0.f, 0.04f, 0.f, 0.f})
        asset.error.values.push_back(value);
    const double squares = (0.03 * 0.03 + 0.04 * 0.04) / 4,
                 unshadowed = 0.25 * 3 / 4 * (1 / (4 * pi) + 1 / (3 * pi));
    EXPECT_NEAR(measureAsset(asset).transferError, std::sqrt(squares / unshadowed), 1e-7);
    EXPECT_LT(measureAsset(asset).emissionError, 0);
    asset.emission = {{1, 2, 2}, {0, 0, 0}, {0, 0, 0}, {0, 0, 4}};
    asset.emissionError = {{0, 0, 0}, {0.3f, 0, 0}, {0, 0.4f, 0}, {0, 0, 0}};
    EXPECT_NEAR(measureAsset(asset).emissionError, 0.5 / 5, 1e-7);
    asset.emission.assign(4, {});
    EXPECT_LT(measureAsset(asset).emissionError, 0);
    asset.albedo.assign(4, {});
    EXPECT_LT(measureAsset(asset).transferError, 0);
  }
}

}  // namespace
}  // namespace shprt
