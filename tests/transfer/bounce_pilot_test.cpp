// The pilot against the bowl, where every bounce is known (bowl.h), and against what must be exact.
#include "shprt/transfer/bounce_pilot.h"

#include <gtest/gtest.h>

#include <numeric>

#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/zonal.h"
#include "tests/transfer/bowl.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

BouncePilot pilotOf(const Scene& scene, const PilotOptions& options) {
  std::vector<std::uint32_t> all(scene.mesh.positions.size());
  std::iota(all.begin(), all.end(), 0u);
  return pilotBounces(PreparedScene(scene), all, all.size(), options);
}

constexpr Vec3f greyOf(float albedo) {
  return {albedo, albedo, albedo};
}

// Twice as wide as the interval of 95%, and the rounding of the sphere to triangles.
void expectWithin(const Interval& interval, double expected, const std::string& what) {
  constexpr double kFaceting = 0.004;
  const double room = interval.high - interval.low + kFaceting;
  EXPECT_NEAR(interval.value, expected, room) << what;
  EXPECT_LE(interval.low, interval.value);
  EXPECT_LE(interval.value, interval.high);
}

TEST(BouncePilot, EachBounceInABowlHasItsKnownShare) {
  for (const double f : {0.25, 0.5, 0.75})
    for (const double rho : {0.2, 0.9}) {
      const Scene scene = test::paintedBowl(f, greyOf(static_cast<float>(rho)));
      const BouncePilot pilot = pilotOf(scene, {.vertices = 128, .rays = 64, .seed = 5});
      const std::string where = "f " + std::to_string(f) + ", albedo " + std::to_string(rho);
      expectWithin(pilot.visibility, 1 - f, "visibility, " + where);
      for (int k = 1; k <= 4; ++k) {
        const double expected = (1 - f) * std::pow(rho * f, k);
        const PilotBounce& bounce = pilot.bounces[static_cast<std::size_t>(k) - 1];
        const std::string what = "bounce " + std::to_string(k) + ", " + where;
        for (const Interval& power : bounce.power) expectWithin(power, expected, "power of " + what);
        if (k == 1) expectWithin(bounce.norm, expected, "norm of " + what);
      }
      expectWithin(pilot.total, (1 - f) * rho * f / (1 - rho * f), "all bounces, " + where);
      EXPECT_NEAR(pilot.ratio, rho * f, 0.15 * rho * f + 0.03) << where;
    }
}

TEST(BouncePilot, PredictsHowManyBouncesAnErrorAsksFor) {
  const double f = 0.75, rho = 0.8;
  const BouncePilot pilot = pilotOf(test::paintedBowl(f, greyOf(0.8f)), {.vertices = 256, .rays = 64});
  const double all = (1 - f) * rho * f / (1 - rho * f);
  for (const double error : {0.1, 0.03, 0.01, 0.001}) {
    const double exact = std::log(error / all) / std::log(rho * f);
    EXPECT_NEAR(pilot.bouncesFor(error), std::ceil(exact), 1) << error;
    EXPECT_LE(pilot.remainderAfter(pilot.bouncesFor(error)), error * 1.0001);
  }
  EXPECT_EQ(pilot.bouncesFor(1), 0);
}

// 95% of the intervals hold the truth; of 60, fewer than 51 do with a probability of 0.4% only.
TEST(BouncePilot, IntervalsHoldTheTruthAsOftenAsTheySay) {
  const double f = 0.5, rho = 0.8, expected = (1 - f) * rho * f;
  const Scene scene = test::paintedBowl(f, greyOf(0.8f), 32, 64);
  const PreparedScene prepared(scene);
  std::vector<std::uint32_t> all(scene.mesh.positions.size());
  std::iota(all.begin(), all.end(), 0u);
  int power = 0, norm = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const BouncePilot pilot =
        pilotBounces(prepared, all, all.size(), {.vertices = 64, .rays = 32, .seed = seed});
    const PilotBounce& first = pilot.bounces.front();
    power += first.power[0].low <= expected && expected <= first.power[0].high;
    norm += first.norm.low <= expected && expected <= first.norm.high;
  }
  EXPECT_GE(power, 51);
  EXPECT_GE(norm, 51);
}

TEST(BouncePilot, ColoursBounceEachForItself) {
  const double f = 0.6, rho[3] = {0.9, 0.5, 0.1};
  const BouncePilot pilot = pilotOf(test::paintedBowl(f, {0.9f, 0.5f, 0.1f}), {.vertices = 128, .rays = 64});
  double all[3], mean = 0, spread = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    expectWithin(pilot.bounces[0].power[c], (1 - f) * rho[c] * f, "channel " + std::to_string(c));
    all[c] = (1 - f) * rho[c] * f / (1 - rho[c] * f);
    mean += all[c] / 3;
  }
  for (const double one : all) spread += (one - mean) * (one - mean) / 3;
  expectWithin(pilot.colourBleed, std::sqrt(spread), "colour bleed");
  EXPECT_LT(pilotOf(test::paintedBowl(f, greyOf(0.5f)), {}).colourBleed.high, 1e-12);
}

// A bowl that glows with radiance e: irradiance/pi is f e, and f e / (1 - rho f) with all bounces.
TEST(BouncePilot, LightOfTheSceneItselfBounces) {
  const double f = 0.5, rho = 0.6;
  Scene scene = test::paintedBowl(f, greyOf(0.6f));
  scene.materials[0].emission = {2, 1, 0};
  const BouncePilot pilot = pilotOf(scene, {.vertices = 256, .rays = 64});
  EXPECT_NEAR(pilot.emission[0], 2 * f / (1 - rho * f), 0.03);
  EXPECT_NEAR(pilot.emission[1], 1 * f / (1 - rho * f), 0.015);
  EXPECT_EQ(pilot.emission[2], 0);
  EXPECT_GT(pilot.emissionReach, 0.99);
}

TEST(BouncePilot, WhatIsBlackOrTurnedAwayReflectsNothing) {
  const BouncePilot black = pilotOf(test::paintedBowl(0.5, {}), {});
  EXPECT_GT(black.met, 0u);
  EXPECT_EQ(black.total.high, 0);

  Scene outside = test::paintedBowl(0.5, greyOf(0.8f));  // seen from below, where it is black
  const auto floor = static_cast<std::uint32_t>(outside.mesh.positions.size());
  Mesh mesh = outside.mesh;
  test::addPatch(mesh, {-1, -2, -1}, {0, 0, 2}, {2, 0, 0}, 4);
  for (const bool twoSided : {false, true}) {
    Mesh scene = mesh;
    if (twoSided) {
      Mesh back = outside.mesh;
      for (Vec3f& normal : back.normals) normal = -normal;
      for (Triangle& triangle : back.triangles) std::swap(triangle[1], triangle[2]);
      test::append(scene, back);
    }
    const Scene lit = test::grey(scene, 0.8f);
    std::vector<std::uint32_t> receivers(25);
    std::iota(receivers.begin(), receivers.end(), floor);
    const BouncePilot pilot = pilotBounces(PreparedScene(lit), receivers, receivers.size(), {});
    EXPECT_LT(pilot.visibility.value, 0.9);
    EXPECT_EQ(pilot.met > 0, twoSided);
  }
}

TEST(BouncePilot, ConvexSurfacesAreExact) {
  const Scene scene = test::grey(test::makeIcosphere(2), 0.8f);
  const BouncePilot pilot = pilotOf(scene, {.degree = 4, .bandDegree = 8});
  EXPECT_EQ(pilot.visibility.value, 1);
  EXPECT_EQ(pilot.met, 0u);
  EXPECT_EQ(pilot.shadow.high, 0);
  const std::vector<double> factors = clampedCosineFactors(8);
  for (std::size_t l = 0; l <= 8; ++l) {
    const double factor = factors[l] / std::numbers::pi;
    EXPECT_NEAR(pilot.bandEnergy[l],
                factor * factor * (2 * static_cast<double>(l) + 1) / (4 * std::numbers::pi), 1e-9);
  }
  // All vertices were drawn and no ray met anything: little is left possible, but not nothing.
  EXPECT_GT(pilot.total.high, 0);
  EXPECT_LT(pilot.total.high, 0.01);
}

TEST(BouncePilot, SeesTheSameWithAnyNumberOfThreads) {
  const Scene scene = test::paintedBowl(0.7, {0.8f, 0.4f, 0.2f});
  setThreadCount(1);
  const BouncePilot one = pilotOf(scene, {.seed = 3});
  setThreadCount(2);
  const BouncePilot two = pilotOf(scene, {.seed = 3});
  setThreadCount(0);
  const BouncePilot other = pilotOf(scene, {.seed = 4});
  EXPECT_EQ(one.total.value, two.total.value);
  EXPECT_EQ(one.total.high, two.total.high);
  EXPECT_EQ(one.bandEnergy, two.bandEnergy);
  EXPECT_EQ(one.power, two.power);
  EXPECT_NE(one.power, other.power);
}

// Half of the receivers see everything and are no candidates: squared norms and shares halve.
TEST(BouncePilot, ReceiversThatSeeEverythingCountInTheMeans) {
  const Scene scene = test::paintedBowl(0.5, greyOf(0.8f));
  std::vector<std::uint32_t> all(scene.mesh.positions.size());
  std::iota(all.begin(), all.end(), 0u);
  const PreparedScene prepared(scene);
  const BouncePilot whole = pilotBounces(prepared, all, all.size(), {});
  const BouncePilot half = pilotBounces(prepared, all, 2 * all.size(), {});
  EXPECT_NEAR(half.total.value, whole.total.value / std::sqrt(2), 1e-12);
  EXPECT_NEAR(1 - half.visibility.value, (1 - whole.visibility.value) / 2, 1e-12);
  EXPECT_NEAR(half.power[0], whole.power[0] / 2, 1e-12);
}

}  // namespace
}  // namespace shprt
