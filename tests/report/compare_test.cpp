// Comparison: what differs is found, counted and placed; what agrees within tolerance is not.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "shprt/report/compare.h"

namespace shprt {
namespace {

TransferAsset makeAsset(int channels) {
  TransferAsset asset;
  asset.transfer.degree = 1;
  asset.transfer.channels = channels;
  asset.transfer.vertexCount = 4;
  for (int c = 0; c < channels; ++c)
    for (int i = 0; i < 16; ++i) asset.transfer.values.push_back(1 + static_cast<float>(i) / 16);
  asset.positions.assign(4, {1, 2, 3});
  asset.normals.assign(4, {0, 0, 1});
  asset.albedo.assign(4, {0.5f, 0.5f, 0.5f});
  asset.triangles = {{0, 1, 2}, {1, 2, 3}};
  return asset;
}

TEST(Compare, EqualAssetsAreEqualWithoutTolerance) {
  const Comparison comparison = compareAssets(makeAsset(1), makeAsset(1), {});
  EXPECT_TRUE(comparison.equal());
  EXPECT_EQ(comparison.total.compared, 16u);
  EXPECT_TRUE(comparison.worst.empty());
  EXPECT_TRUE(compareAssets(makeAsset(1), makeAsset(3), {}).equal());  // one channel stands for three
}

TEST(Compare, FindsTheDegreeAndTheVertex) {
  const TransferAsset a = makeAsset(1);
  TransferAsset b = a;
  b.transfer.row(0, 2)[3] += 0.25f;
  const Comparison comparison = compareAssets(a, b, {});
  EXPECT_FALSE(comparison.equal());
  EXPECT_EQ(comparison.total.beyond, 1u);
  EXPECT_DOUBLE_EQ(comparison.total.maximumError, 0.25);
  EXPECT_DOUBLE_EQ(comparison.total.rmsError, 0.25 / 4);
  EXPECT_EQ(comparison.perDegree[0].beyond, 0u);
  EXPECT_EQ(comparison.perDegree[1].beyond, 1u);
  ASSERT_EQ(comparison.worst.size(), 1u);
  EXPECT_EQ(comparison.worst[0].vertex, 3u);
  EXPECT_EQ(comparison.worst[0].coefficient, 2);
  EXPECT_TRUE(compareAssets(a, b, {.relative = 0, .absolute = 0.25}).equal());
  EXPECT_FALSE(compareAssets(a, b, {.relative = 0, .absolute = 0.2499}).equal());
  EXPECT_TRUE(compareAssets(a, b, {.relative = 0.15, .absolute = 0}).equal());
}

TEST(Compare, SeesGeometry) {
  const TransferAsset a = makeAsset(1);
  TransferAsset b = a;
  b.positions[2].y += 1;
  EXPECT_EQ(compareAssets(a, b, {}).differingParts.size(), 1u);
  EXPECT_TRUE(compareAssets(a, b, {.relative = 0, .absolute = 1}).equal());
  b = a;
  b.triangles[1] = {1, 3, 2};
  EXPECT_FALSE(compareAssets(a, b, {.relative = 1, .absolute = 100}).equal());
  b = a;
  b.textureCoordinates.assign(4, {0, 0});
  EXPECT_FALSE(compareAssets(a, b, {}).equal());
}

TEST(Compare, SeesEmission) {
  TransferAsset a = makeAsset(1);
  a.emission.assign(4, {1, 2, 3});
  TransferAsset b = a;
  EXPECT_TRUE(compareAssets(a, b, {}).equal());
  b.emission[3].z += 0.25f;
  ASSERT_EQ(compareAssets(a, b, {}).differingParts.size(), 1u);
  EXPECT_EQ(compareAssets(a, b, {}).differingParts[0],
            "emission: 1 of 12 values beyond tolerance, largest difference 0.25");
  EXPECT_TRUE(compareAssets(a, b, {.relative = 0, .absolute = 0.25}).equal());
  EXPECT_TRUE(compareAssets(a, b, {.relative = 0.08, .absolute = 0}).equal());
  b.emission.clear();
  EXPECT_FALSE(compareAssets(a, b, {.relative = 1, .absolute = 100}).equal());
  EXPECT_EQ(compareAssets(b, a, {}).differingParts.at(0), "emission: only one of them has any");
}

TEST(Compare, SeesStandardErrors) {
  TransferAsset a = makeAsset(1);
  a.error = {.degree = 1, .channels = 1, .vertexCount = 4, .values = std::vector<float>(8, 0.5f)};
  a.emission.assign(4, {1, 1, 1});
  a.emissionError.assign(4, {0.25f, 0.25f, 0.25f});
  TransferAsset b = a;
  EXPECT_TRUE(compareAssets(a, b, {}).equal());
  b.error.row(0, 1)[2] += 0.125f;
  ASSERT_EQ(compareAssets(a, b, {}).differingParts.size(), 1u);
  EXPECT_EQ(compareAssets(a, b, {}).differingParts[0],
            "error: 1 of 8 values beyond tolerance, largest difference 0.125");
  EXPECT_TRUE(compareAssets(a, b, {.relative = 0, .absolute = 0.125}).equal());
  b = a;
  b.emissionError[1].y = 0;
  EXPECT_EQ(compareAssets(a, b, {}).differingParts.at(0),
            "emissionError: 1 of 12 values beyond tolerance, largest difference 0.25");
  b.emissionError.clear();
  EXPECT_EQ(compareAssets(a, b, {}).differingParts.at(0), "emissionError: only one of them has any");
  b = a;
  b.error = {};
  EXPECT_EQ(compareAssets(b, a, {.relative = 1, .absolute = 100}).differingParts.at(0),
            "error: only one of them has any");
}

TEST(Compare, TakesOneChannelOfErrorsForThree) {
  TransferAsset grey = makeAsset(1), coloured = makeAsset(3);
  grey.error = {.degree = 1, .channels = 1, .vertexCount = 4, .values = {1, 2, 3, 4, 5, 6, 7, 8}};
  coloured.error = {.degree = 1, .channels = 3, .vertexCount = 4, .values = {}};
  for (int channel = 0; channel < 3; ++channel)
    coloured.error.values.insert(coloured.error.values.end(), grey.error.values.begin(),
                                 grey.error.values.end());
  EXPECT_TRUE(compareAssets(grey, coloured, {}).equal());
  coloured.error.row(2, 1)[0] = 0;
  EXPECT_EQ(compareAssets(grey, coloured, {}).differingParts.at(0),
            "error: 1 of 24 values beyond tolerance, largest difference 5");
}

TEST(Compare, SaysWhyNot) {
  TransferAsset a = makeAsset(1), b = a;
  b.transfer.degree = 0;
  EXPECT_NE(compareAssets(a, b, {}).whyNot.find("degrees 1 and 0"), std::string::npos);
  b = a;
  b.transfer.vertexCount = 3;
  EXPECT_FALSE(compareAssets(a, b, {}).comparable);
  EXPECT_FALSE(compareAssets(a, b, {}).equal());
  LightCoefficients light{.degree = 0, .coefficients = {{1, 2, 3}}, .source = "", .statisticsJson = ""},
      other{.degree = 1, .coefficients = {4, {0, 0, 0}}, .source = "", .statisticsJson = ""};
  EXPECT_FALSE(compareLights(light, other, {}).comparable);
  Image small{1, 1, {{}}}, large{2, 1, {{}, {}}};
  EXPECT_FALSE(compareImages(small, large, {}).comparable);
}

TEST(Compare, NotANumberIsNeverEqual) {
  Image a{2, 1, {{1, 1, 1}, {NAN, 1, 1}}}, b = a;
  EXPECT_FALSE(compareImages(a, b, {.relative = 1, .absolute = 1e9}).equal());
  EXPECT_TRUE(std::isnan(compareImages(a, b, {}).total.maximumError));
  Image infinite{1, 1, {{INFINITY, 0, 0}}};
  EXPECT_TRUE(compareImages(infinite, infinite, {}).equal());
  // No relative tolerance makes an infinity agree with anything else.
  const Image finite{1, 1, {{1, 0, 0}}}, negative{1, 1, {{-INFINITY, 0, 0}}};
  EXPECT_FALSE(compareImages(infinite, finite, {.relative = 2, .absolute = 0}).equal());
  EXPECT_FALSE(compareImages(infinite, negative, {.relative = 2, .absolute = 0}).equal());
}

TEST(Compare, PutsVerticesThatAreNoNumberFirst) {
  TransferAsset a = makeAsset(1), b = a;
  b.transfer.row(0, 1)[2] = NAN;
  b.transfer.row(0, 3)[0] += 1;
  a.transfer.row(0, 2)[1] = b.transfer.row(0, 2)[1] = INFINITY;  // the same on both sides: no difference
  const Comparison comparison = compareAssets(a, b, {});
  EXPECT_EQ(comparison.total.beyond, 2u);
  ASSERT_EQ(comparison.worst.size(), 2u);
  EXPECT_EQ(comparison.worst[0].vertex, 2u);
  EXPECT_EQ(comparison.worst[0].coefficient, 1);
  EXPECT_EQ(comparison.worst[1].vertex, 0u);
  EXPECT_EQ(comparison.worst[1].error, 1);
}

TEST(Compare, LargeValuesDoNotOverflow) {
  LightCoefficients a{0, {{1e300, 1, 1}}, "", ""}, b = a;
  b.coefficients[0][0] = 2e300;
  const Comparison comparison = compareLights(a, b, {});
  EXPECT_NEAR(comparison.total.rmsError / (1e300 / std::sqrt(3.0)), 1, 1e-12);
  EXPECT_NEAR(comparison.total.rmsReference / (1e300 / std::sqrt(3.0)), 1, 1e-12);
}

TEST(Compare, ReportsAsTextAndJson) {
  const TransferAsset a = makeAsset(1);
  TransferAsset b = a;
  b.transfer.row(0, 0)[1] += 0.5f;
  const Comparison comparison = compareAssets(a, b, {});
  EXPECT_NE(formatComparison(comparison, "a", "b").find("DIFFERENT: a and b"), std::string::npos);
  const auto json = nlohmann::json::parse(comparisonToJson(comparison, "a", "b"));
  EXPECT_EQ(json["equal"], false);
  EXPECT_EQ(json["total"]["maximumError"], 0.5);
  EXPECT_EQ(json["perDegree"].size(), 2u);
  EXPECT_EQ(json["worst"][0]["vertex"], 1);
}

}  // namespace
}  // namespace shprt
