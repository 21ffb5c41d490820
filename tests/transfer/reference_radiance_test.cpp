// Radiance by path tracing against closed forms, against the tests' own path tracer, and against itself.
#include "shprt/transfer/reference_radiance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "shprt/base/parallel.h"
#include "shprt/sampling/random.h"
#include "shprt/sh/basis.h"
#include "tests/transfer/path_tracer.h"
#include "tests/transfer/truth_meshes.h"

namespace shprt {
namespace {

using std::numbers::pi;

class GreySky final : public Sky {
 public:
  explicit GreySky(std::function<double(Vec3d)> radiance, int rows = 32)
      : radiance_(std::move(radiance)),
        sampler_(rows, 2 * rows, [this](Vec3d direction) { return std::fabs(radiance_(direction)); }) {}

  Vec3d radiance(Vec3d direction) const override { return Vec3d{1, 1, 1} * radiance_(direction); }
  Vec3d sample(double u, double v) const override { return sampler_.sample(u, v); }
  double density(Vec3d direction) const override { return sampler_.density(direction); }

 private:
  std::function<double(Vec3d)> radiance_;
  SkySampler sampler_;
};

GreySky constantSky(double radiance) {
  return GreySky([radiance](Vec3d) { return radiance; });
}

// A disc of radiance 1 and angular radius asin(sine).
GreySky sun(Vec3d centre, double sine, int rows) {
  const double cosine = std::sqrt(1 - sine * sine);
  return GreySky([=](Vec3d direction) { return dot(direction, centre) > cosine ? 1.0 : 0.0; }, rows);
}

std::vector<std::uint32_t> allVertices(const Scene& scene) {
  std::vector<std::uint32_t> vertices(scene.mesh.positions.size());
  std::iota(vertices.begin(), vertices.end(), 0u);
  return vertices;
}

TEST(SkySampler, SamplesFollowADensityThatIntegratesToOne) {
  constexpr int kRows = 8, kColumns = 12, kSide = 512;
  const SkySampler sampler(kRows, kColumns, [](Vec3d d) { return std::max(0.0, d.x) + 0.1; });
  // Each cell's solid angle times its density is its share of samples. Of a regular grid of points, the share
  // is off by at most the cell's edge in the grid.
  std::array<std::array<double, kColumns>, kRows> share{};
  const auto cellOf = [](Vec3d d) {
    const double row = std::acos(d.y) / pi * kRows, column = (1 - std::atan2(d.x, d.z) / pi) / 2 * kColumns;
    return std::pair(std::clamp(static_cast<std::size_t>(row), std::size_t{0}, std::size_t{kRows - 1}),
                     std::clamp(static_cast<std::size_t>(column), std::size_t{0}, std::size_t{kColumns - 1}));
  };
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const auto [row, column] = cellOf(sampler.sample((i + 0.5) / kSide, (j + 0.5) / kSide));
      share[row][column] += 1.0 / (kSide * kSide);
    }
  double total = 0;
  for (std::size_t row = 0; row < kRows; ++row)
    for (std::size_t column = 0; column < kColumns; ++column) {
      const double top = pi * double(row) / kRows, bottom = pi * double(row + 1) / kRows;
      const double theta = (top + bottom) / 2, phi = pi * (1 - 2 * (double(column) + 0.5) / kColumns);
      const Vec3d middle{std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)};
      const double solidAngle = 2 * pi / kColumns * (std::cos(top) - std::cos(bottom));
      const double expected = sampler.density(middle) * solidAngle;
      total += expected;
      EXPECT_NEAR(share[row][column], expected, 4.0 / kSide * std::sqrt(expected) + 1e-4);
    }
  EXPECT_NEAR(total, 1, 1e-12);
}

TEST(SkySampler, BlackSkiesAreSampledUniformly) {
  const SkySampler sampler(4, 4, [](Vec3d) { return 0.0; });
  EXPECT_NEAR(sampler.density(normalize({1, 2, 3})), 1 / (4 * pi), 1e-12);
}

TEST(ReferenceRadiance, ConvexSurfacesSendBackAConstantSky) {
  const Scene scene = test::grey(test::makeIcosphere(2), 0.6f);
  const PreparedScene prepared(scene);
  const auto estimates =
      traceRadiance(prepared, allVertices(scene), constantSky(2), {.rays = 128, .passes = 16, .seed = 3});
  for (const RadianceEstimate& estimate : estimates) {
    EXPECT_FALSE(estimate.buried);
    EXPECT_NEAR(estimate.radiance.x, 1.2, 6 * estimate.standardError.x + 1e-6);
    EXPECT_LT(estimate.standardError.x, 0.01);
  }
}

TEST(ReferenceRadiance, InsideTrianglesOfCoarseConvexMeshesTheSame) {
  const Scene scene = test::grey(test::makeIcosphere(1), 0.6f);
  const PreparedScene prepared(scene);
  const auto samples = sampleSurface(scene, prepared.topology, {.perTriangle = 4});
  const auto estimates =
      traceRadiance(prepared, samples, constantSky(2), {.rays = 128, .passes = 16, .seed = 3});
  for (const RadianceEstimate& estimate : estimates)
    EXPECT_NEAR(estimate.radiance.y, 1.2, 6 * estimate.standardError.y + 1e-6);
}

// In a closed room whose walls emit, light adds up to emission / (1 - albedo).
TEST(ReferenceRadiance, ClosedFurnace) {
  for (const float albedo : {0.3f, 0.8f}) {
    Scene scene = test::grey(test::makeRoom({}, {1, 1, 1}, 3), albedo);
    scene.materials[0].emission = {0.5f, 0.5f, 0.5f};
    const PreparedScene prepared(scene);
    const auto estimates =
        traceRadiance(prepared, allVertices(scene), constantSky(0), {.rays = 16, .passes = 8, .seed = 5});
    const double expected = 0.5 / (1 - static_cast<double>(albedo));
    double mean = 0, variance = 0;
    for (const RadianceEstimate& estimate : estimates) {
      mean += estimate.radiance.x / static_cast<double>(estimates.size());
      variance += std::pow(estimate.standardError.x / static_cast<double>(estimates.size()), 2);
      // Eight passes tell standard errors to a quarter.
      EXPECT_NEAR(estimate.radiance.x, expected, 8 * estimate.standardError.x + 1e-6);
    }
    EXPECT_NEAR(mean, expected, 4 * std::sqrt(variance) + 1e-6);
  }
}

// bowl.h has the closed form; under a constant sky it holds for every vertex alone.
TEST(ReferenceRadiance, BowlUnderAConstantSky) {
  constexpr double kFraction = 0.75, kAlbedo = 0.7;
  const Scene scene = test::grey(test::makeBowl(kFraction, 14), static_cast<float>(kAlbedo));
  const PreparedScene prepared(scene);
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t vertex = 0; vertex < 300; vertex += 10) vertices.push_back(vertex);
  const auto estimates =
      traceRadiance(prepared, vertices, constantSky(1), {.rays = 128, .passes = 8, .seed = 7});
  const double expected = kAlbedo * (1 - kFraction) / (1 - kAlbedo * kFraction);
  double mean = 0;
  for (const RadianceEstimate& estimate : estimates)
    mean += estimate.radiance.x / static_cast<double>(estimates.size());
  EXPECT_NEAR(mean, expected, 0.01 * expected);
}

// A disc of sine s at an angle theta from the normal brings s^2 cos(theta) of its radiance, in units of pi.
TEST(ReferenceRadiance, FindsASmallSun) {
  constexpr double kSine = 0.004;
  const Vec3d centre = normalize({0.3, 1, 0.2});
  const GreySky sky = sun(centre, kSine, 512);
  const Scene scene = test::grey(test::makeBox({}, {1, 1, 1}, 2), 0.5f);
  const PreparedScene prepared(scene);
  const auto estimates =
      traceRadiance(prepared, allVertices(scene), sky, {.rays = 256, .passes = 16, .seed = 1});
  for (std::uint32_t vertex = 0; vertex < estimates.size(); ++vertex) {
    const double cosine = std::max(0.0, dot(prepared.topology.normal(vertex), centre));
    const RadianceEstimate& estimate = estimates[vertex];
    EXPECT_NEAR(estimate.radiance.x, 0.5 * kSine * kSine * cosine, 6 * estimate.standardError.x + 1e-12);
    // Of the rays that follow the cosine, a share s^2 would find it: none of these 4,096.
    EXPECT_LE(estimate.standardError.x, 0.05 * 0.5 * kSine * kSine);
  }
}

// The sun on a floor, and what a wall gets of it: both find the sun by its own directions.
TEST(ReferenceRadiance, SunThatReachesAWallByTheFloor) {
  constexpr double kSine = 0.02;
  const Vec3d centre = normalize({-0.5, 1, 0});  // behind the wall's face
  Mesh mesh;
  test::addPatch(mesh, {0, 0, -20}, test::kZ * 40, test::kX * 40, 4, 4, test::kY);
  test::addPatch(mesh, {0, 0, -0.5}, test::kY, test::kZ, 2, 2, test::kX);
  const Scene scene = test::grey(mesh, 0.5f);
  // The wall stands in the sun's way: what it shades is a strip of half its height.
  const PreparedScene prepared(scene);
  std::vector<std::uint32_t> top;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    if (mesh.normals[v].x > 0.5f && mesh.positions[v].y > 0.9f && mesh.positions[v].z == 0) top.push_back(v);
  ASSERT_EQ(top.size(), 1u);
  const auto estimates = traceRadiance(prepared, top, sun(centre, kSine, 128), {.rays = 512, .passes = 16});
  // The lit floor's share of the hemisphere of the wall's top, by a Riemann sum over the floor.
  const double onFloor = 0.5 * kSine * kSine * centre.y;
  double share = 0;
  constexpr int kSteps = 2000;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double x = 40 * std::pow((i + 0.5) / kSteps, 3), z = 20 * std::pow((j + 0.5) / kSteps, 3);
      const double area = 40 * 3 * std::pow((i + 0.5) / kSteps, 2) / kSteps * 20 * 3 *
                          std::pow((j + 0.5) / kSteps, 2) / kSteps;
      const bool shaded = x < 0.5 && z < 0.5;
      const double squared = x * x + z * z + 1;
      if (!shaded) share += 2 * x * area / (pi * squared * squared);
    }
  EXPECT_NEAR(estimates[0].radiance.x, 0.5 * onFloor * share,
              0.01 * 0.5 * onFloor * share + 4 * estimates[0].standardError.x);
  EXPECT_LT(estimates[0].standardError.x, 0.01 * estimates[0].radiance.x) << estimates[0].radiance.x;
}

// Facets whose corners have their normal: both trace the same surfaces.
TEST(ReferenceRadiance, AgreesWithThePathTracerUnderASmoothLight) {
  constexpr int kDegree = 2;
  const std::array<double, 9> light = {3, 0.5, 1, -0.7, 0.4, 0.3, -0.2, 0.6, -0.5};
  const GreySky sky([&](Vec3d direction) {
    std::array<double, 9> basis;
    evaluateSh(kDegree, direction, basis);
    return std::inner_product(basis.begin(), basis.end(), light.begin(), 0.0);
  });
  const Scene scene = test::grey(test::makeRoomWithWindow(4), 0.7f);
  const PreparedScene prepared(scene);
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t vertex = 0; vertex < scene.mesh.positions.size(); vertex += 5)
    vertices.push_back(vertex);
  const auto estimates = traceRadiance(prepared, vertices, sky, {.rays = 128, .passes = 8, .seed = 11});
  const test::PathTracer tracer(scene);
  double difference = 0, variance = 0, total = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const test::PathEstimate truth =
        tracer.atVertex(vertices[i], {.degree = kDegree, .paths = 4096, .seed = 4});
    double expected = 0, error = estimates[i].standardError.x;
    for (std::size_t k = 0; k < light.size(); ++k) {
      expected += 0.7 * light[k] * truth.transfer[k].x;
      error += 0.7 * std::fabs(light[k]) * truth.transferError[k].x;
    }
    EXPECT_NEAR(estimates[i].radiance.x, expected, 4 * error + 1e-4) << "vertex " << vertices[i];
    difference += estimates[i].radiance.x - expected;
    variance += error * error;
    total += expected;
  }
  EXPECT_NEAR(difference / total, 0, 4 * std::sqrt(variance) / total);
}

// Two seeds differ by what their standard errors say. With n passes each, the square of the difference over
// the sum of squared errors has a mean between 1 and (n-1)/(n-3).
TEST(ReferenceRadiance, StandardErrorsAreHonest) {
  constexpr int kPasses = 12;
  const GreySky sky([](Vec3d d) { return std::exp(3 * d.y) + d.x; });
  const Scene scene = test::grey(test::makeRoomWithWindow(8), 0.5f);
  const PreparedScene prepared(scene);
  const std::vector<std::uint32_t> vertices = allVertices(scene);
  const auto trace = [&](std::uint64_t seed) {
    return traceRadiance(prepared, vertices, sky, {.rays = 8, .passes = kPasses, .seed = seed});
  };
  const auto first = trace(1), second = trace(2);
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const double variance = std::pow(first[i].standardError.x, 2) + std::pow(second[i].standardError.x, 2);
    if (!(variance > 0)) continue;
    sum += std::pow(first[i].radiance.x - second[i].radiance.x, 2) / variance;
    ++count;
  }
  // The mean of so many squares of z-scores is itself uncertain by sqrt(2/count), somewhat more with so few
  // passes.
  EXPECT_GT(count, 300);
  EXPECT_GT(sum / count, 1 - 5 * std::sqrt(2 / count));
  EXPECT_LT(sum / count, (kPasses - 1.0) / (kPasses - 3) + 5 * std::sqrt(2 / count));
}

TEST(ReferenceRadiance, SameBitsForAnyThreadsAndWhateverElseIsAskedFor) {
  const GreySky sky([](Vec3d d) { return 1 + d.x; });
  const Scene scene = test::grey(test::makeRoomWithWindow(4), 0.7f);
  const PreparedScene prepared(scene);
  const std::vector<std::uint32_t> vertices = allVertices(scene);
  const ReferenceOptions options{.rays = 16, .passes = 3, .seed = 9};
  setThreadCount(1);
  const auto one = traceRadiance(prepared, vertices, sky, options);
  setThreadCount(0);
  const auto many = traceRadiance(prepared, vertices, sky, options);
  const std::vector<std::uint32_t> some = {vertices[7], vertices[2]};
  const auto few = traceRadiance(prepared, some, sky, options);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_EQ(one[i].radiance, many[i].radiance);
    EXPECT_EQ(one[i].standardError, many[i].standardError);
  }
  EXPECT_EQ(few[0].radiance, many[7].radiance);
  EXPECT_EQ(few[1].radiance, many[2].radiance);
}

TEST(ReferenceRadiance, BuriedVerticesAreTold) {
  Mesh mesh = test::makeBox({}, {1, 1, 1}, 2);
  test::append(mesh, test::makeBox({0.3, 0.3, 0.3}, {0.2, 0.2, 0.2}, 1));
  const Scene scene = test::grey(mesh, 0.5f);
  const PreparedScene prepared(scene);
  const std::vector<std::uint32_t> vertices = {0, static_cast<std::uint32_t>(mesh.positions.size() - 1)};
  const auto estimates = traceRadiance(prepared, vertices, constantSky(1), {.rays = 16, .passes = 2});
  EXPECT_FALSE(estimates[0].buried);
  EXPECT_TRUE(estimates[1].buried);
  EXPECT_EQ(estimates[1].radiance, Vec3d{});
}

}  // namespace
}  // namespace shprt
