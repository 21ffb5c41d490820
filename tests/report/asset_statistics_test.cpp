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

}  // namespace
}  // namespace shprt
