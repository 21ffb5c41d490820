// Interreflected transfer where it is known in closed form: the spherical bowl, perpendicular squares, the
// furnace. The path tracer that other tests take for the truth is held against the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "shprt/transfer/bake.h"
#include "tests/transfer/path_tracer.h"
#include "tests/transfer/truth_meshes.h"

namespace shprt {
namespace {

using std::numbers::pi;
using test::kX, test::kY, test::kZ;

// Outgoing radiance under a sky of radiance 1.
double underUniformSky(const Bake& bake, std::size_t vertex) {
  return static_cast<double>(bake.transfer.row(0, 0)[vertex]) * std::sqrt(4 * pi);
}

struct Deviation {
  double rms = 0, maximum = 0, mean = 0;  // relative
};

// Of irradiance / pi from one expected value, over all vertices of a grey scene.
Deviation deviation(const Bake& bake, double albedo, double expected) {
  Deviation result;
  const std::size_t count = bake.transfer.vertexCount;
  for (std::size_t v = 0; v < count; ++v) {
    const double relative = underUniformSky(bake, v) / albedo / expected - 1;
    result.rms += relative * relative / static_cast<double>(count);
    result.mean += relative / static_cast<double>(count);
    result.maximum = std::max(result.maximum, std::abs(relative));
  }
  result.rms = std::sqrt(result.rms);
  return result;
}

// The mean over n lattice points of what is 1 inside an outline of length L on the unit disc and 0 outside
// differs from its integral by the strata that the outline cuts, some L sqrt(2 n / pi), each with a variance
// of at most 1/4 its weight squared. L = 8 is more than the outline of any hemispherical view of a rectangle
// or a circle.
double latticeSigma(int n) {
  return std::sqrt(8 * std::sqrt(2 * n / pi) / 4) / n;
}

// Seen from a point of a sphere, a part of the sphere has a form factor of its share of the area, wherever it
// is: so irradiance E / pi is the same everywhere, and E = (1 - f) + rho f E. What is equal everywhere is
// interpolated without error, so what is left is the direct light's sampling, 0.0018 RMS of an open vertex at
// 1024 rays for every f (bounces average it out), and the rim's sliver. In a bowl as dark as f = 3/4, rho =
// 0.2 that alone is 0.6% of the irradiance.
TEST(TruthBowl, IrradianceUnderAUniformSky) {
  const int rings = 16, rays = 1024;
  for (const double f : {0.25, 0.5, 0.75}) {
    const Mesh bowl = test::makeBowl(f, rings);
    for (const double rho : {0.2, 0.5, 0.9}) {
      const Bake bake =
          bakeInterreflected(test::grey(bowl, static_cast<float>(rho)),
                             {.degree = 0, .rays = rays, .seed = 1, .bounces = {}, .error = 1e-4});
      const double expected = (1 - f) / (1 - rho * f);
      const Deviation found = deviation(bake, rho, expected);
      const std::string where = "f " + std::to_string(f) + ", albedo " + std::to_string(rho) + ", RMS " +
                                std::to_string(found.rms) + ", maximum " + std::to_string(found.maximum) +
                                ", mean " + std::to_string(found.mean);
      const bool isDark = f == 0.75 && rho == 0.2;
      EXPECT_LT(found.rms, isDark ? 0.0065 : 0.005) << where;
      EXPECT_LT(found.rms * expected, 0.0025) << where;
      // Four of the bound on sigma, and it is for every of 817 vertices.
      EXPECT_LT(found.maximum * expected, 4 * latticeSigma(rays)) << where;
      EXPECT_LT(std::abs(found.mean) * expected, 0.0005) << where;
    }
  }
}

TEST(TruthBowl, EveryBounceAddsItsTermOfTheSeries) {
  const double f = 0.75, rho = 0.5;
  const Scene scene = test::grey(test::makeBowl(f, 10), static_cast<float>(rho));
  double expected = 0, term = 1 - f;
  for (int bounces = 0; bounces <= 4; ++bounces, term *= rho * f) {
    expected += term;
    const Bake bake = bakeInterreflected(scene, {.degree = 0, .rays = 1024, .seed = 2, .bounces = bounces});
    const Deviation found = deviation(bake, rho, expected);
    EXPECT_LT(found.rms * expected, 0.0025) << bounces << " bounces";
    EXPECT_LT(std::abs(found.mean), 0.002) << bounces << " bounces";
    ASSERT_EQ(bake.statistics.bounces.size(), static_cast<std::size_t>(bounces));
    // Norms are those of what a bounce adds; the unshadowed transfer's first coefficient is 1 / sqrt(4 pi).
    if (bounces > 0) {
      EXPECT_NEAR(bake.statistics.bounces.back().norm, term, 0.01 * term) << bounces;
    }
  }
}

// 1e4 sizes away a float mesh has steps of 1e-3 of its size: the bowl's rings are coarse, so that its facets
// still turn by more than their corners' rounding does.
TEST(TruthBowl, AtAnySizeAndPlace) {
  const double f = 0.5, rho = 0.5;
  for (const auto& [scale, sizesAway] : {std::pair{1e-3, 0.0}, {1e3, 0.0}, {1.0, 1e4}}) {
    const Mesh bowl =
        test::moved(test::makeBowl(f, 8), scale, Vec3d{1, -0.5, 0.75} * (2 * scale * sizesAway));
    const Bake bake =
        bakeInterreflected(test::grey(bowl, static_cast<float>(rho)),
                           {.degree = 0, .rays = 1024, .seed = 3, .bounces = {}, .error = 1e-4});
    const Deviation found = deviation(bake, rho, (1 - f) / (1 - rho * f));
    EXPECT_LT(found.rms, 0.01) << scale << " " << sizesAway;
    EXPECT_LT(std::abs(found.mean), 0.002) << scale << " " << sizesAway;
  }
}

// The path tracer on the same bowl: within four standard errors at some vertices, rim and bottom among them.
TEST(TruthBowl, PathTracerAgrees) {
  const double f = 0.75, rho = 0.5;
  const Scene scene = test::grey(test::makeBowl(f, 24), static_cast<float>(rho));
  const test::PathTracer tracer(scene);
  const auto last = static_cast<std::uint32_t>(scene.mesh.positions.size() - 1);
  for (const std::uint32_t vertex : {0u, 100u, 1000u, last}) {
    for (const int bounces : {0, 1, -1}) {
      test::PathOptions options{.degree = 0, .paths = 16384, .seed = 5};
      if (bounces >= 0) options.bounces = bounces;
      const test::PathEstimate estimate = tracer.atVertex(vertex, options);
      const double series = bounces < 0 ? 1 / (1 - rho * f) : bounces == 0 ? 1 : 1 + rho * f;
      // The rim's sliver, and walks that start a hair above a facet instead of on the sphere.
      const double allowance = 2e-3;
      const double y00 = std::sqrt(1 / (4 * pi));
      EXPECT_NEAR(estimate.transfer[0].x / y00, (1 - f) * series,
                  4 * estimate.transferError[0].x / y00 + allowance)
          << vertex << ", bounces " << bounces;
    }
  }
}

// Lambert's formula: the form factor from a point with normal n to a polygon above its horizon, which must
// not pass through the point. Corners counter-clockwise as the point sees them.
double pointFormFactor(Vec3d point, Vec3d n, std::span<const Vec3d> corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = corners[i] - point, b = corners[(i + 1) % corners.size()] - point;
    const Vec3d normal = cross(a, b);
    sum += std::atan2(length(normal), dot(a, b)) * dot(n, normalize(normal));
  }
  return std::abs(sum) / (2 * pi);
}

// A floor [0,1]^2 at the foot of a wall of the same size.
constexpr std::array<Vec3d, 4> kWall{Vec3d{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}};

double cornerFormFactor(Vec3d floorPoint) {
  // Just before the foot of the wall half of all that is seen is wall.
  return floorPoint.x > 0 ? pointFormFactor(floorPoint, kY, kWall) : 0.5;
}

// Where the form factor has no limit: it is 1/4 along the side of the floor and 1/2 along the foot of the
// wall.
bool isEndOfFoot(Vec3d floorPoint) {
  return floorPoint.x == 0 && (floorPoint.z == 0 || floorPoint.z == 1);
}

// Between two perpendicular unit squares with a common edge.
// F = (pi/4 + pi/4 - sqrt(2) atan(1 / sqrt(2)) + ln(3/4) / 4) / pi.
double squareFormFactor() {
  return (pi / 2 - std::sqrt(2) * std::atan(1 / std::sqrt(2)) + std::log(0.75) / 4) / pi;
}

TEST(TruthCorner, ClosedFormsAgreeWithEachOther) {
  EXPECT_NEAR(squareFormFactor(), 0.20004, 5e-6);
  const int side = 400;
  double sum = 0;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) sum += cornerFormFactor({(i + 0.5) / side, 0, (j + 0.5) / side});
  EXPECT_NEAR(sum / (side * side), squareFormFactor(), 1e-5);
}

test::SceneBuilder perpendicularSquares(int cells) {
  test::SceneBuilder builder;
  builder.add(test::makePatch({}, kZ, kX, cells), {1, 1, 1});
  builder.add(test::makePatch({}, kY, kZ, cells), {0, 0, 0}, {1, 1, 1});
  return builder;
}

TEST(TruthCorner, FormFactorOfPerpendicularSquares) {
  const int cells = 8, rays = 8192;
  const Scene scene = perpendicularSquares(cells).build();
  const Bake bake = bakeInterreflected(scene, {.degree = 0, .rays = rays, .seed = 4, .bounces = 0});
  ASSERT_EQ(bake.emission.size(), scene.mesh.positions.size());
  const std::vector<double> areas = test::vertexAreas(scene.mesh);
  double received = 0, expected = 0, variance = 0;
  for (std::size_t v = 0; v < 81; ++v) {
    const Vec3d point = toDouble(scene.mesh.positions[v]);
    const double found = static_cast<double>(bake.emission[v].x);
    const double formFactor = isEndOfFoot(point) ? std::clamp(found, 0.25, 0.5) : cornerFormFactor(point);
    EXPECT_NEAR(found, formFactor, 3 * latticeSigma(rays)) << v;
    received += areas[v] * found;
    expected += areas[v] * formFactor;
    variance += std::pow(areas[v] * latticeSigma(rays), 2);
  }
  EXPECT_NEAR(received, expected, 3 * std::sqrt(variance));
  // The trapezoidal rule itself, on a form factor with a kink at the edge, is off by 2% of a grid of 8.
  EXPECT_NEAR(received, squareFormFactor(), 0.02 * squareFormFactor());
}

TEST(TruthCorner, PathTracerAgrees) {
  const Scene scene = perpendicularSquares(8).build();
  const test::PathTracer tracer(scene);
  for (const std::uint32_t v : {4u, 9u, 27u, 40u, 53u, 79u}) {
    const test::PathEstimate estimate =
        tracer.atVertex(v, {.degree = 0, .paths = 16384, .seed = 6, .bounces = 0});
    // Starts over both sides of the common edge see it from 1e-3 of a cell.
    EXPECT_NEAR(estimate.emission.x, cornerFormFactor(toDouble(scene.mesh.positions[v])),
                4 * estimate.emissionError.x + 1e-3)
        << v;
  }
}

// Closed, glowing everywhere, every ray ends on radiance 1 / (1 - rho): an average of equals has no error.
TEST(TruthFurnace, ClosedBoxThatGlows) {
  for (const float rho : {0.2f, 0.5f, 0.9f}) {
    test::SceneBuilder builder;
    builder.add(test::makeRoom({-1, -2, -0.5}, {2, 3, 1}, 4), {rho, rho, rho}, {1, 1, 1});
    const Scene scene = builder.build();
    const Bake bake =
        bakeInterreflected(scene, {.degree = 1, .rays = 256, .seed = 1, .bounces = {}, .error = 1e-3});
    for (std::size_t v = 0; v < bake.emission.size(); ++v)
      ASSERT_NEAR(bake.emission[v].x * (1 - rho), 1, 0.005) << v << ", albedo " << rho;
    for (const float value : bake.transfer.values) ASSERT_EQ(value, 0);
  }
}

TEST(TruthFurnace, PathTracerAgrees) {
  test::SceneBuilder builder;
  builder.add(test::makeRoom({-1, -2, -0.5}, {2, 3, 1}, 4), {0.5f, 0.8f, 0}, {1, 1, 1});
  const Scene scene = builder.build();
  const test::PathTracer tracer(scene);
  for (const std::uint32_t vertex : {0u, 31u, 90u}) {
    const test::PathEstimate estimate = tracer.atVertex(vertex, {.degree = 0, .paths = 8192, .seed = 7});
    EXPECT_NEAR(estimate.emission.x, 2, 4 * estimate.emissionError.x) << vertex;
    EXPECT_NEAR(estimate.emission.y, 5, 4 * estimate.emissionError.y) << vertex;
    EXPECT_EQ(estimate.emission.z, 1) << vertex;
    EXPECT_EQ(estimate.transfer[0], Vec3d{}) << vertex;
  }
}

}  // namespace
}  // namespace shprt
