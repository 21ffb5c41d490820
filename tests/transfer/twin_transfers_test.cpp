// Two noisy measurements tell a difference from noise.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "shprt/transfer/twin_transfers.h"

namespace shprt {
namespace {

constexpr int kDegree = 2;
constexpr std::uint32_t kVertices = 4000;
// The clamped cosine's A_l / pi are 1, 2/3 and 1/4; band l adds (2l + 1) / 4 pi of their squares.
const double kUnshadowedNorm = std::sqrt((1 + 3 * 4.0 / 9 + 5 / 16.0) / (4 * std::numbers::pi));

// Per vertex a true transfer along the first coefficient, and noise of the given deviation in all.
TwinTransfers measured(double truth, double noise, unsigned seed) {
  TwinTransfers twins(kDegree);
  twins.resize(kVertices);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, noise);
  for (int twin = 0; twin < 2; ++twin) {
    TransferCoefficients transfer;
    transfer.degree = kDegree;
    transfer.vertexCount = kVertices;
    for (int i = 0; i < transfer.rows(); ++i)
      for (std::uint32_t v = 0; v < kVertices; ++v)
        transfer.values.push_back(
            static_cast<float>(kUnshadowedNorm * ((i == 0 ? truth : 0) + normal(random))));
    for (std::uint32_t v = 0; v < kVertices; ++v) twins.store(transfer, twin, v);
  }
  return twins;
}

TEST(TwinTransfers, DifferencesAreInUnitsOfTheUnshadowedNorm) {
  EXPECT_NEAR(measured(0.75, 0, 1).difference(0, measured(0.5, 0, 2), 1), 0.25, 1e-6);
}

TEST(TwinTransfers, NoiseAloneHasAsManySignsOfEitherKind) {
  const TwinTransfers a = measured(0.5, 0.1, 1), b = measured(0.5, 0.1, 2);
  std::uint32_t zeros = 0;
  for (std::uint32_t v = 0; v < kVertices; ++v) zeros += a.difference(v, b, v) == 0 ? 1 : 0;
  EXPECT_NEAR(zeros, kVertices / 2.0, 4 * std::sqrt(kVertices / 4.0));
}

TEST(TwinTransfers, SquaredDifferencesAreUnbiased) {
  // Nine coefficients of noise 0.1 each, twice, would add 9 * 2 * 0.01 to a plain square of 0.25.
  const TwinTransfers a = measured(1, 0.1, 3), b = measured(0.5, 0.1, 4);
  double mean = 0;
  for (std::uint32_t v = 0; v < kVertices; ++v) {
    const double d = a.difference(v, b, v);
    mean += d * d / kVertices;
  }
  // Deviation of one product: sqrt(2 * 0.25 * 0.02 + 9 * 0.02^2) = 0.117; hardly any is negative and cut off.
  EXPECT_NEAR(mean, 0.25, 4 * 0.117 / std::sqrt(kVertices));
}

TEST(TwinTransfers, MeansAndCopiesAreKnown) {
  TwinTransfers twins = measured(1, 0, 5);
  const TwinTransfers other = measured(0, 0, 6);
  twins.copy(other, 7, 1);
  twins.resize(kVertices + 1);
  EXPECT_FALSE(twins.known(kVertices));
  twins.setMean(0, 1, kVertices);
  EXPECT_TRUE(twins.known(kVertices));
  EXPECT_NEAR(twins.difference(kVertices, other, 0), 0.5, 1e-6);
  EXPECT_NEAR(twins.difference(kVertices, twins, 0), 0.5, 1e-6);
}

}  // namespace
}  // namespace shprt
