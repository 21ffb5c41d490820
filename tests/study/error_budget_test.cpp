// Budgets of scenes and lights in which it is known what errors there are.
#include "shprt/study/error_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "shprt/light/project_probe.h"
#include "shprt/sampling/random.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/zonal.h"
#include "shprt/study/half_rounding.h"
#include "shprt/study/probe_sampler.h"
#include "shprt/study/surface_subset.h"
#include "tests/transfer/test_meshes.h"
#include "tests/transfer/truth_meshes.h"

namespace shprt {
namespace {

using std::numbers::pi;

// Some light that comes mostly from above, with all bands up to `degree`.
LightCoefficients smoothLight(int degree) {
  LightCoefficients light;
  light.degree = degree;
  for (int i = 0; i < coefficientCount(degree); ++i) {
    const double value = i == 0 ? 3 : (0.8 - 0.1 * (i % 5)) / (1 + bandOf(i));
    light.coefficients.push_back({value, 0.5 * value, 0.8 * value});
  }
  return light;
}

struct Measured {
  ErrorBudget budget;
  StudySection section;
  int announced = 0;
};

Measured measure(const Scene& scene, const StudyLight& light, StudyOptions options,
                 const std::string& model) {
  const PreparedScene prepared(scene);
  StudyJournal journal({}, "");
  EffectPlan plan;
  plan.model = model;
  plan.bounces = model == "interreflected" ? 3 : 0;
  plan.degree = options.degree;
  options.quick = true;
  Measured measured;
  StudyRun run{prepared, "scene", "scene", light,
               options,  plan,    journal, [&](const std::string&) { ++measured.announced; }};
  measured.budget = measureErrorBudget(run);
  run.announce = [](const std::string&) {};
  measured.section = errorBudget().measure(run);
  EXPECT_GE(journal.reused(), 5u);
  EXPECT_EQ(measured.announced, kErrorBudgetSteps);
  return measured;
}

TEST(ErrorBudget, NothingIsWrongWithAConvexObjectUnderABandLimitedLight) {
  const Scene scene = test::grey(test::makeIcosphere(2), 0.5f);
  const auto [budget, section, announced] =
      measure(scene, {"light", {}, smoothLight(3)}, {.degree = 4}, "interreflected");
  EXPECT_EQ(budget.vertices, scene.mesh.positions.size());
  EXPECT_EQ(budget.truncation, 0);
  EXPECT_EQ(budget.sampling, 0);
  EXPECT_EQ(budget.bounces, 0);
  EXPECT_GT(budget.noise, 0);
  EXPECT_LT(budget.noise, 0.01);
  // What is left is how well the noise of truth is known.
  EXPECT_LT(budget.gathering, 0.6 * budget.noise);
  EXPECT_LT(budget.total, 0.6 * budget.noise);
  EXPECT_GT(budget.rounding, 0);
  EXPECT_LT(budget.rounding, 0x1p-23);
  EXPECT_GT(budget.half, 0);
  EXPECT_LT(budget.half, 0x1p-10);
}

// A light beyond the degree leaves albedo/pi A_l c_lm y_lm(n) of each of its bands out.
TEST(ErrorBudget, TruncationIsWhatTheBandsBeyondBring) {
  constexpr int kDegree = 2, kLightDegree = 8;
  const LightCoefficients light = projectDirectional({0.3, 1, 0.5}, {1, 0.5, 2}, kLightDegree);
  const Scene scene = test::grey(test::makeIcosphere(2), 0.5f);
  const ErrorBudget budget = measure(scene, {"sun", {}, light}, {.degree = kDegree}, "unshadowed").budget;
  const std::vector<double> factors = clampedCosineFactors(kLightDegree);
  double beyond = 0, whole = 0;
  std::array<double, coefficientCount(kLightDegree)> basis;
  for (const Vec3f& normal : scene.mesh.normals) {
    evaluateSh(kLightDegree, toDouble(normal), basis);
    double all = 0, missing = 0;
    for (int i = 0; i < coefficientCount(kLightDegree); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double part =
          factors[static_cast<std::size_t>(bandOf(i))] * light.coefficients[at][0] * basis[at];
      all += part;
      if (bandOf(i) > kDegree) missing += part;
    }
    beyond += missing * missing;
    whole += all * all;
  }
  const double expected = std::sqrt(beyond / whole);
  EXPECT_GT(expected, 0.02);
  EXPECT_LT(budget.noise, 0.25 * expected);
  EXPECT_NEAR(budget.truncation, expected, 0.05 * expected);
  EXPECT_NEAR(budget.total, expected, 0.05 * expected);
  EXPECT_EQ(budget.sampling, 0);
  EXPECT_EQ(budget.bounces, 0);
}

TEST(ErrorBudget, FewRaysMakeSamplingTheLargest) {
  const Scene scene = test::grey(test::makeRoomWithWindow(4), 0.3f);
  const auto [budget, section, announced] =
      measure(scene, {"light", {}, smoothLight(2)}, {.degree = 2, .rays = 8}, "interreflected");
  EXPECT_EQ(budget.truncation, 0);
  EXPECT_GT(budget.sampling, 2 * budget.gathering);
  EXPECT_GT(budget.sampling, 2 * budget.bounces);
  EXPECT_NEAR(budget.total, budget.sampling, 0.2 * budget.total);
  EXPECT_NE(section.text.find("sampling, 8 rays has"), std::string::npos) << section.text;
  ASSERT_EQ(section.tables.size(), 2u);
  const auto figure = std::find_if(section.figures.begin(), section.figures.end(),
                                   [](const auto& pair) { return pair.first == "error-budget.sampling"; });
  ASSERT_NE(figure, section.figures.end());
  EXPECT_EQ(figure->second, budget.sampling);
}

TEST(ErrorBudget, BouncesThatArePassedOverAreTheLargest) {
  const Scene scene = test::grey(test::makeBowl(0.5, 6), 0.8f);
  const ErrorBudget budget =
      measure(scene, {"light", {}, smoothLight(2)}, {.degree = 2, .rays = 256}, "shadowed").budget;
  // bowl.h: a share 0.8 * 0.5 of the light has bounced.
  EXPECT_NEAR(budget.bounces, 0.4, 0.1);
  EXPECT_GT(budget.bounces, 4 * budget.sampling);
  EXPECT_GT(budget.bounces, 4 * budget.gathering);
  EXPECT_NEAR(budget.total, budget.bounces, 0.2 * budget.bounces);
}

// One triangle under light from one side: radiance is linear in the normal's and corners' values, unless the
// corners' normals differ, as on a coarse sphere; interpolating over finer meshes errs four times less with
// every subdivision.
TEST(ErrorBudget, InterpolationFallsWithTheSquareOfTheEdges) {
  const auto interpolation = [](int subdivisions) {
    const Scene scene = test::grey(test::makeIcosphere(subdivisions), 0.5f);
    return measure(scene, {"light", {}, smoothLight(2)}, {.degree = 2}, "unshadowed").budget.interpolation;
  };
  EXPECT_NEAR(interpolation(0) / interpolation(1), 4, 1.2);
}

TEST(ErrorBudget, SaysThatItNeedsALight) {
  const Scene scene = test::grey(test::makeIcosphere(0), 0.5f);
  const PreparedScene prepared(scene);
  StudyJournal journal({}, "");
  StudyRun run{prepared, "scene", "scene", {}, {}, {}, journal, [](const std::string&) {}};
  const StudySection section = errorBudget().measure(run);
  EXPECT_FALSE(section.missing.empty());
  EXPECT_TRUE(section.tables.empty());
}

TEST(HalfRounding, IsToElevenBitsWithTiesToEven) {
  EXPECT_EQ(roundToHalf(1 + 0x1p-11f), 1);
  EXPECT_EQ(roundToHalf(1 + 0x1.8p-11f), 1 + 0x1p-10f);
  EXPECT_EQ(roundToHalf(1 + 0x3p-11f), 1 + 0x1p-9f);
  EXPECT_EQ(roundToHalf(-0.1f), -0x1.998p-4f);
  EXPECT_EQ(roundToHalf(0x1p-25f), 0);
  EXPECT_EQ(roundToHalf(0x1.8p-25f), 0x1p-24f);
  EXPECT_EQ(roundToHalf(0x3p-25f), 0x1p-23f);
  EXPECT_EQ(roundToHalf(65504.0f), 65504.0f);
  EXPECT_EQ(roundToHalf(0.0f), 0);
}

TEST(SurfaceSubset, IsSpreadOverTheReceivers) {
  Mesh mesh;
  test::addPatch(mesh, {}, {3, 0, 0}, {0, 1, 0}, 1);
  test::addPatch(mesh, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 4);
  const Scene scene = test::grey(mesh, 0.5f);
  const PreparedScene prepared(scene);
  const std::vector<std::uint32_t> vertices = spreadVertices(scene, 10, 1);
  EXPECT_EQ(std::set<std::uint32_t>(vertices.begin(), vertices.end()).size(), 10u);
  EXPECT_TRUE(std::is_sorted(vertices.begin(), vertices.end()));
  EXPECT_EQ(spreadVertices(scene, 100, 1).size(), scene.mesh.positions.size());
  // Three quarters of the area are the first patch's.
  const std::vector<SurfaceSample> samples = spreadSamples(scene, prepared.topology, 400, 1);
  const auto first = std::count_if(samples.begin(), samples.end(),
                                   [](const SurfaceSample& sample) { return sample.triangle < 2; });
  EXPECT_EQ(first, 300);
  for (const SurfaceSample& sample : samples) EXPECT_LE(sample.u + sample.v, 1.0001f);
}

EnvironmentMap paintedMap(EnvironmentLayout layout, int width, int height) {
  EnvironmentMap map;
  map.layout = layout;
  map.image = {width, height, std::vector<Vec3f>(static_cast<std::size_t>(width * height))};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto draw = [&](unsigned dimension) {
        const double u = uniformRandom(3, static_cast<std::uint64_t>(y * width + x), dimension);
        return static_cast<float>(u < 0.02 ? 200 : u);
      };
      map.image.at(x, y) = {draw(0), draw(1), draw(2)};
    }
  return map;
}

// Sampling by density, the mean of radiance over density is the integral of the picture.
TEST(ProbeSky, IntegratesToWhatProjectionSeesInEveryLayout) {
  struct Case {
    EnvironmentLayout layout;
    int width, height;
  };
  for (const auto& [layout, width, height] :
       {Case{EnvironmentLayout::kLatitudeLongitude, 32, 16}, Case{EnvironmentLayout::kAngularMap, 48, 48},
        Case{EnvironmentLayout::kMirroredBall, 48, 48}, Case{EnvironmentLayout::kVerticalCross, 36, 48},
        Case{EnvironmentLayout::kCubeStrip, 12, 72}}) {
    const EnvironmentMap map = paintedMap(layout, width, height);
    const ProbeSky sky(map);
    const double expected = projectProbe(map, {.degree = 0}).light.coefficients[0][1] * std::sqrt(4 * pi);
    double mean = 0, squares = 0;
    constexpr int kSide = 400;
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j) {
        const auto index = static_cast<std::uint64_t>(i * kSide + j);
        const Vec3d direction =
            sky.sample((i + uniformRandom(5, index, 0)) / kSide, (j + uniformRandom(5, index, 1)) / kSide);
        const double value = sky.radiance(direction).y / sky.density(direction) / (kSide * kSide);
        mean += value;
        squares += value * value;
      }
    EXPECT_NEAR(mean, expected, 0.01 * expected) << layoutName(layout);
    // Bright pixels are found by their own directions: else this would be some hundred.
    EXPECT_LT(std::sqrt(squares) * kSide, 3 * expected) << layoutName(layout);
  }
}

TEST(ProbeSky, ShowsThePixelOfADirectionAndStandsInForThoseThatAreNotFinite) {
  EnvironmentMap map = paintedMap(EnvironmentLayout::kLatitudeLongitude, 16, 8);
  for (int x = 0; x < 16; ++x) map.image.at(x, 3).y = std::numeric_limits<float>::quiet_NaN();
  map.image.at(5, 5) = {-2, 1, 3};
  const ProbeSky sky(map);
  const double used = projectProbe(map, {.degree = 0}).solidAngle;
  const Vec3d seen = sky.radiance(pixelFootprint(map.layout, 16, 8, 5, 5).direction);
  EXPECT_NEAR(seen.x, -2 * 4 * pi / used, 1e-9);
  EXPECT_NEAR(seen.z, 3 * 4 * pi / used, 1e-9);
  EXPECT_EQ(sky.radiance(pixelFootprint(map.layout, 16, 8, 2, 3).direction), Vec3d{});
}

TEST(ExpandedSky, IsTheSumOfItsBands) {
  const LightCoefficients light = smoothLight(3);
  const ExpandedSky sky(light, 1);
  const Vec3d direction = normalize({1, -2, 0.5});
  std::array<double, 4> basis;
  evaluateSh(1, direction, basis);
  double expected = 0;
  for (std::size_t i = 0; i < 4; ++i) expected += light.coefficients[i][2] * basis[i];
  EXPECT_NEAR(sky.radiance(direction).z, expected, 1e-14);
}

}  // namespace
}  // namespace shprt
