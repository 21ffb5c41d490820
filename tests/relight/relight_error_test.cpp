// Standard errors of radiance: against errors that are drawn and relit, and where the answer is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "shprt/base/parallel.h"
#include "shprt/light/project_probe.h"
#include "shprt/relight/error_summary.h"
#include "shprt/relight/relight.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/gauss_legendre.h"
#include "shprt/sh/rotation.h"

namespace shprt {
namespace {

double component(const Vec3f& v, int colour) {
  return static_cast<double>(colour == 0 ? v.x : colour == 1 ? v.y : v.z);
}

LightCoefficients makeLight(int degree) {
  LightCoefficients light;
  light.degree = degree;
  for (int i = 0; i < coefficientCount(degree); ++i)
    light.coefficients.push_back({std::cos(i), 3 * std::cos(3.1 * i), -std::cos(5.3 * i)});
  return light;
}

// Errors that differ between vertices, bands and channels, some of them zero; normals all around.
TransferAsset makeAsset(int degree, int channels, std::size_t vertices) {
  TransferAsset asset;
  asset.transfer = {.degree = degree, .channels = channels, .vertexCount = vertices, .values = {}};
  asset.transfer.values.assign(static_cast<std::size_t>(channels * coefficientCount(degree)) * vertices,
                               0.25f);
  asset.error = {.degree = degree, .channels = channels, .vertexCount = vertices, .values = {}};
  for (std::size_t i = 0; i < static_cast<std::size_t>(channels * (degree + 1)) * vertices; ++i)
    asset.error.values.push_back(i % 7 == 6 ? 0.f : 0.1f + 0.1f * std::sin(static_cast<float>(i)));
  for (std::size_t v = 0; v < vertices; ++v) {
    const double angle = 2.4 * double(v), z = std::sin(1.7 * double(v));
    asset.normals.push_back(toFloat(normalize({std::cos(angle), std::sin(angle), 2 * z})));
  }
  return asset;
}

void addEmission(TransferAsset& asset) {
  for (std::size_t v = 0; v < asset.transfer.vertexCount; ++v) {
    asset.emission.push_back({1, 2, 3});
    asset.emissionError.push_back({0, 0.5f, 0.125f * static_cast<float>(v)});
  }
}

// A direction distributed by the cosine about the normal.
Vec3d drawDirection(Vec3d normal, std::mt19937_64& random) {
  std::normal_distribution<double> gauss;
  // A point of the unit sphere that touches the plane at its origin, seen from there.
  return normalize(normal + normalize({gauss(random), gauss(random), gauss(random)}));
}

// The asset with one draw of what its errors stand for: noise in some directions of each vertex's hemisphere,
// its bands scaled.
TransferAsset drawn(const TransferAsset& asset, std::mt19937_64& random) {
  constexpr int kDirections = 12;
  TransferAsset draw = asset;
  std::normal_distribution<double> gauss;
  const int degree = asset.transfer.degree;
  std::vector<double> basis(static_cast<std::size_t>(coefficientCount(degree)));
  for (std::size_t v = 0; v < asset.transfer.vertexCount; ++v)
    for (int k = 0; k < kDirections; ++k) {
      evaluateSh(degree, drawDirection(toDouble(asset.normals[v]), random), basis);
      const double noise = gauss(random) / std::sqrt(kDirections);
      for (int channel = 0; channel < asset.transfer.channels; ++channel)
        for (std::size_t i = 0; i < basis.size(); ++i) {
          const int l = bandOf(static_cast<int>(i));
          // The squares of a band add up to (2l+1)/(4 pi) in every direction.
          const double scale = std::sqrt(4 * std::numbers::pi / (2 * l + 1));
          draw.transfer.row(channel, static_cast<int>(i))[v] +=
              static_cast<float>(double(asset.error.row(channel, l)[v]) * scale * noise * basis[i]);
        }
    }
  for (std::size_t v = 0; v < asset.emissionError.size(); ++v) {
    const Vec3f& s = asset.emissionError[v];
    const auto noise = static_cast<float>(gauss(random));
    draw.emission[v] += s * noise;
  }
  return draw;
}

TEST(RelightError, IsTheDeviationOfRelitErrors) {
  constexpr int kDraws = 3000;
  constexpr std::size_t kVertices = 12;
  // Of n draws with the fourth moment k sigma^4, the deviation is off by sqrt((k-1)/4n), relatively. Noise in
  // d directions of random places has k = 3 + (3q-3)/d, q being the mean of the fourth power of the light's
  // pattern over the square of the mean of its second, at most 6 here: k < 4.25. Five of those hold for all
  // of the 72 with a probability of 0.9999.
  const double limit = 5 * std::sqrt(3.25 / (4.0 * kDraws));
  for (const int channels : {1, 3}) {
    TransferAsset asset = makeAsset(3, channels, kVertices);
    addEmission(asset);
    const LightCoefficients light = makeLight(3);
    const double emissionScale = 2.5;
    const std::vector<Vec3f> mean = relight(asset, light, emissionScale),
                             predicted = relightError(asset, light, emissionScale);
    ASSERT_EQ(predicted.size(), kVertices);
    double squares[kVertices][3] = {};
    std::mt19937_64 random(17);
    for (int k = 0; k < kDraws; ++k) {
      const std::vector<Vec3f> radiance = relight(drawn(asset, random), light, emissionScale);
      for (std::size_t v = 0; v < kVertices; ++v)
        for (int colour = 0; colour < 3; ++colour)
          squares[v][colour] += std::pow(component(radiance[v], colour) - component(mean[v], colour), 2);
    }
    for (std::size_t v = 0; v < kVertices; ++v)
      for (int colour = 0; colour < 3; ++colour) {
        const double deviation = std::sqrt(squares[v][colour] / kDraws);
        EXPECT_NEAR(component(predicted[v], colour) / deviation, 1, limit)
            << "vertex " << v << " colour " << colour;
      }
  }
}

// Light in band 1 along the normal: s sqrt(4 pi/3) sqrt(3/(4 pi)) c cos theta, and the cosine-weighted mean
// of cos^2 is 1/2; across the normal, of sin^2 cos^2 phi, it is 1/4.
TEST(RelightError, KnowsWhereLightComesFrom) {
  TransferAsset asset = makeAsset(2, 1, 2);
  std::fill(asset.error.values.begin(), asset.error.values.end(), 0.f);
  asset.normals = {{0, 0, 1}, {0, 0, 1}};
  asset.error.row(0, 1)[1] = 0.5f;
  LightCoefficients light = makeLight(2);
  for (auto& coefficient : light.coefficients) coefficient = {7, 7, 7};
  light.coefficients[1] = {0, 0, 0}, light.coefficients[2] = {3, 0, 0}, light.coefficients[3] = {0, 0, 3};
  const std::vector<Vec3f> error = relightError(asset, light, 1);
  EXPECT_EQ(error[0], Vec3f{});
  EXPECT_NEAR(error[1].x, 1.5 * std::sqrt(0.5), 1e-6);
  EXPECT_EQ(error[1].y, 0);
  EXPECT_NEAR(error[1].z, 1.5 * std::sqrt(0.25), 1e-6);
}

TEST(RelightError, IsExactUnderEvenLight) {
  const TransferAsset asset = makeAsset(4, 3, 40);
  LightCoefficients light = makeLight(4);
  for (auto& coefficient : light.coefficients) coefficient = {};
  light.coefficients[0] = {2, 3, -4};
  const std::vector<Vec3f> error = relightError(asset, light, 1);
  for (std::size_t v = 0; v < 40; ++v) {
    EXPECT_FLOAT_EQ(error[v].x, 2 * asset.error.row(0, 0)[v]);
    EXPECT_FLOAT_EQ(error[v].y, 3 * asset.error.row(1, 0)[v]);
    EXPECT_FLOAT_EQ(error[v].z, 4 * asset.error.row(2, 0)[v]);
  }
}

// The mean of the variance over all turns of the light is sum_l s_l^2 |L_l|^2 / (2l+1). Turning the normals
// instead, a rule on the sphere that is exact to degree 13 averages a light of degree 2 and a cosine.
TEST(RelightError, AveragesOverTurnsToTheEnergyOfBands) {
  constexpr int kRings = 7, kAzimuths = 14;
  const GaussLegendreRule rule = gaussLegendre(kRings);
  TransferAsset asset = makeAsset(2, 1, std::size_t{kRings} * kAzimuths);
  const double s[] = {0.1, 0.3, 0.2};
  std::vector<double> weights;
  for (std::size_t v = 0; v < asset.normals.size(); ++v) {
    const double z = rule.nodes[v / kAzimuths], r = std::sqrt(1 - z * z),
                 phi = 2 * std::numbers::pi * double(v % kAzimuths) / kAzimuths;
    asset.normals[v] = toFloat({r * std::cos(phi), r * std::sin(phi), z});
    weights.push_back(rule.weights[v / kAzimuths] / (2 * kAzimuths));
    for (int l = 0; l <= 2; ++l) asset.error.row(0, l)[v] = static_cast<float>(s[l]);
  }
  const LightCoefficients light = makeLight(2);
  const std::vector<Vec3f> error = relightError(asset, light, 1);
  for (int colour = 0; colour < 3; ++colour) {
    double mean = 0, expected = 0;
    for (std::size_t v = 0; v < error.size(); ++v)
      mean += weights[v] * std::pow(component(error[v], colour), 2);
    for (int i = 0; i < 9; ++i) {
      const int l = bandOf(i);
      expected += s[l] * s[l] * std::pow(light.coefficients[size_t(i)][size_t(colour)], 2) / (2 * l + 1);
    }
    EXPECT_NEAR(mean / expected, 1, 1e-6) << colour;
  }
}

TEST(RelightError, UsesTheBandsThatBothHave) {
  const TransferAsset asset = makeAsset(4, 3, 10);
  const LightCoefficients longer = makeLight(6), shorter = makeLight(2);
  LightCoefficients cut = longer, filled = shorter;
  cut.degree = filled.degree = 4;
  cut.coefficients.resize(25);
  filled.coefficients.resize(25, {0, 0, 0});
  EXPECT_EQ(relightError(asset, longer, 1), relightError(asset, cut, 1));
  const std::vector<Vec3f> low = relightError(asset, shorter, 1), padded = relightError(asset, filled, 1);
  for (std::size_t v = 0; v < low.size(); ++v)
    for (int colour = 0; colour < 3; ++colour)
      EXPECT_NEAR(component(low[v], colour) / component(padded[v], colour), 1, 1e-6);
}

TEST(RelightError, TurnsWithLightAndNormals) {
  TransferAsset asset = makeAsset(4, 3, 40);
  const LightCoefficients light = makeLight(4);
  const std::vector<Vec3f> here = relightError(asset, light, 1);
  const Mat3 turn = parseRotation("euler:zyz,20,50,-130");
  for (Vec3f& normal : asset.normals) normal = toFloat(turn * toDouble(normal));
  const std::vector<Vec3f> there = relightError(asset, rotateLight(light, turn), 1);
  for (std::size_t v = 0; v < here.size(); ++v)
    for (int colour = 0; colour < 3; ++colour)
      EXPECT_NEAR(component(here[v], colour) / component(there[v], colour), 1, 1e-6);
}

TEST(RelightError, ScalesWithLightAndEmissionApart) {
  TransferAsset asset = makeAsset(1, 3, 8);
  addEmission(asset);
  const LightCoefficients black{.degree = 0, .coefficients = {{0, 0, 0}}, .source = "", .statisticsJson = ""};
  EXPECT_EQ(relightError(asset, black, 1), asset.emissionError);
  EXPECT_EQ(relightError(asset, black, 0), std::vector<Vec3f>(8));
  const std::vector<Vec3f> doubled = relightError(asset, black, 2);
  for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(doubled[v], asset.emissionError[v] * 2);
  // Alone in the dark, then with the light: squares add.
  const LightCoefficients light = makeLight(1);
  const std::vector<Vec3f> both = relightError(asset, light, 2), lit = relightError(asset, light, 0);
  for (std::size_t v = 0; v < 8; ++v)
    for (int colour = 0; colour < 3; ++colour)
      EXPECT_NEAR(component(both[v], colour),
                  std::hypot(component(doubled[v], colour), component(lit[v], colour)), 1e-6);
}

TEST(RelightError, IsZeroWhereErrorsAre) {
  TransferAsset asset = makeAsset(4, 3, 10);
  std::fill(asset.error.values.begin(), asset.error.values.end(), 0.f);
  EXPECT_EQ(relightError(asset, makeLight(4), 1), std::vector<Vec3f>(10));
}

TEST(RelightError, IsEmptyWithoutErrors) {
  TransferAsset asset = makeAsset(2, 1, 10);
  asset.error = {};
  EXPECT_TRUE(relightError(asset, makeLight(2), 1).empty());
}

TEST(RelightError, GivesTheSameBitsForAnyNumberOfThreads) {
  for (const int channels : {1, 3}) {
    TransferAsset asset = makeAsset(4, channels, 9000);
    addEmission(asset);
    setThreadCount(1);
    const std::vector<Vec3f> one = relightError(asset, makeLight(4), 1.5);
    setThreadCount(2);
    EXPECT_EQ(one, relightError(asset, makeLight(4), 1.5));
    setThreadCount(0);
  }
}

TEST(ErrorSummary, IsRootMeanSquareAndLargest) {
  const std::vector<Vec3f> radiance = {{3, 0, 0}, {0, -4, 0}}, errors = {{0.25f, 0, 0.25f}, {0, 0.5f, 0}};
  const ErrorSummary summary = summariseErrors(radiance, errors);
  EXPECT_DOUBLE_EQ(summary.rmsRadiance, std::sqrt(25.0 / 6));
  EXPECT_DOUBLE_EQ(summary.rms, std::sqrt(0.375 / 6));
  EXPECT_EQ(summary.largest, 0.5);
  EXPECT_EQ(summary.largestVertex, 1u);
  EXPECT_EQ(summariseErrors({}, {}).rms, 0);
}

}  // namespace
}  // namespace shprt
