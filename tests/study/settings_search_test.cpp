// The search over settings on costs with closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "shprt/study/settings_search.h"

namespace shprt {
namespace {

// Noise 4 / rays, a microsecond per ray, one degree, one way to store.
ErrorCosts powerLaw() {
  ErrorCosts costs;
  costs.effects = {{"interreflected", {}, 0, 1}};
  costs.degrees = {{4, 0}};
  costs.storage = {{{}, 0, 100, 0}};
  for (double rays = 16; rays <= 4096; rays *= 4) costs.rays.push_back({rays, 4 / rays, 1e-2 * rays});
  return costs;
}

// Two significant digits are rounded up, so rays are at most a tenth more than the law asks for.
void expectRays(const std::optional<PredictedSettings>& found, double rays) {
  ASSERT_TRUE(found);
  EXPECT_GE(found->settings.request.rays, std::floor(rays));
  EXPECT_LE(found->settings.request.rays, std::ceil(1.1 * rays));
}

TEST(SettingsSearch, FollowsAPowerLawBetweenMeasurements) {
  for (const double error : {0.2, 0.1, 0.03, 0.01, 0.002})
    expectRays(cheapestSettings(powerLaw(), error, {}), 4 / error);
}

TEST(SettingsSearch, TakesNoMoreThanWasMeasuredAndNoLess) {
  EXPECT_FALSE(cheapestSettings(powerLaw(), 4.0 / 4096 * 0.99, {}));
  const auto loose = cheapestSettings(powerLaw(), 1, {});
  ASSERT_TRUE(loose);
  EXPECT_EQ(loose->settings.request.rays, 16);
}

TEST(SettingsSearch, AddsErrorsInSquares) {
  ErrorCosts costs = powerLaw();
  costs.effects[0].error = 0.02;
  costs.degrees[0].error = 0.03;
  costs.storage[0].error = 0.01;
  EXPECT_FALSE(cheapestSettings(costs, 0.037, {}));  // sqrt(0.02^2 + 0.03^2 + 0.01^2) = 0.0374
  const auto found = cheapestSettings(costs, 0.05, {});
  expectRays(found, 4 / std::sqrt(0.05 * 0.05 - 0.0014));
  EXPECT_NEAR(found->error, 0.05, 1e-9);
}

TEST(SettingsSearch, LeavesOutWhatTheErrorAllows) {
  ErrorCosts costs = powerLaw();
  costs.effects = {{"unshadowed", {}, 0.2, 0}, {"shadowed", {}, 0.05, 0.5}, {"interreflected", 2, 0.001, 1}};
  EXPECT_EQ(cheapestSettings(costs, 0.25, {})->settings.request.model, "unshadowed");
  EXPECT_EQ(cheapestSettings(costs, 0.1, {})->settings.request.model, "shadowed");
  const auto fine = cheapestSettings(costs, 0.01, {});
  EXPECT_EQ(fine->settings.request.model, "interreflected");
  EXPECT_EQ(fine->settings.request.bounces, 2);
}

TEST(SettingsSearch, TakesTheSmallerFileWhereTimesAgree) {
  ErrorCosts costs = powerLaw();
  costs.effects = {{"unshadowed", {}, 0, 0}};
  costs.degrees = {{1, 0.05}, {2, 0.02}, {4, 0.005}, {6, 0}};
  costs.storage = {{{}, 0, 100, 0}, {{true, AssetCompression::kNone}, 1e-3, 50, 0}};
  const auto loose = cheapestSettings(costs, 0.03, {});
  EXPECT_EQ(loose->settings.request.degree, 2);
  EXPECT_TRUE(loose->settings.storage.half);
  const auto fine = cheapestSettings(costs, 5e-4, {});
  EXPECT_EQ(fine->settings.request.degree, 6);
  EXPECT_FALSE(fine->settings.storage.half);
}

TEST(SettingsSearch, AdaptsRaysWhereThatIsFaster) {
  ErrorCosts costs = powerLaw();
  for (const double error : {0.1, 0.03, 0.01}) costs.adaptive.push_back({2 * error, error, 0.02 / error});
  const auto found = cheapestSettings(costs, 0.02, {});
  ASSERT_TRUE(found->settings.request.samplingError);
  EXPECT_LE(errorAskedFor(found->settings.request), 0.04 + 1e-9);
  EXPECT_GE(errorAskedFor(found->settings.request), 0.036);
  EXPECT_FALSE(cheapestSettings(costs, 0.005, {})->settings.request.samplingError);
}

TEST(SettingsSearch, FinestIsOfLeastErrorAndKeepsDefaults) {
  ErrorCosts costs = powerLaw();
  costs.degrees = {{2, 0.1}, {5, 0.01}};
  BakeRequest defaults;
  defaults.seed = 17;
  const PredictedSettings finest = finestSettings(costs, defaults);
  EXPECT_EQ(finest.settings.request.degree, 5);
  EXPECT_GE(finest.settings.request.rays, 4096);
  EXPECT_EQ(finest.settings.request.seed, 17u);
}

TEST(SettingsSearch, NeverPaysMoreForLess) {
  ErrorCosts costs = powerLaw();
  costs.effects = {{"unshadowed", {}, 0.3, 0}, {"shadowed", {}, 0.06, 0.6}, {"interreflected", 1, 0.004, 1}};
  costs.degrees = {{1, 0.2}, {2, 0.05}, {4, 0.01}, {8, 0.001}};
  double before = 1e300;
  for (double error = 0.005; error < 0.5; error *= 1.3) {
    const auto found = cheapestSettings(costs, error, {});
    ASSERT_TRUE(found);
    const double price = double(priceOf(found->seconds, 0).first);
    EXPECT_LE(price, before) << error;
    before = price;
  }
}

TEST(SettingsSearch, PricesWeighBytesWhereTimesAgree) {
  EXPECT_LT(priceOf(0.0011, 10), priceOf(0.001, 20));
  EXPECT_LT(priceOf(1, 20), priceOf(1.6, 10));
}

}  // namespace
}  // namespace shprt
