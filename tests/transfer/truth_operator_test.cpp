// What every transport operator between diffuse surfaces must obey: reciprocity, and that energy never grows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shprt/transfer/bake.h"
#include "tests/transfer/truth_meshes.h"

namespace shprt {
namespace {

using std::numbers::pi;
using test::kX, test::kY, test::kZ;

// A floor with two turned boxes on it under a slanted roof.
// emitting: which of the parts 1 and 2 sends out light.
test::SceneBuilder twoBoxes(int cells, std::size_t emitting) {
  const auto emission = [&](std::size_t part) { return part == emitting ? Vec3f{1, 1, 1} : Vec3f{}; };
  const auto turnedBox = [&](Vec3d low, Vec3d size, double angle, Vec3d offset) {
    Mesh box = test::makeBox(low, size, cells);
    const double c = std::cos(angle), s = std::sin(angle);
    const auto turn = [&](Vec3f p) {
      return toFloat({c * p.x - s * p.y, s * p.x + c * p.y, static_cast<double>(p.z)});
    };
    for (Vec3f& p : box.positions) p = turn(p) + toFloat(offset);
    for (Vec3f& n : box.normals) n = turn(n);
    return box;
  };
  test::SceneBuilder builder;
  builder.add(test::makePatch({-3, 0, -3}, kZ * 6.0, kX * 6.0, 4 * cells), {0.7f, 0.7f, 0.7f});
  builder.add(turnedBox({0, 0, 0}, {1, 0.5, 1.5}, 0.4, {0.4, 0.3, -0.7}), {0.6f, 0.6f, 0.6f}, emission(1));
  builder.add(turnedBox({0, 0, 0}, {0.4, 1.2, 0.7}, -0.3, {-1, 0.5, -0.6}), {0.5f, 0.5f, 0.5f}, emission(2));
  builder.add(test::makePatch({-1, 2, -1}, kX * 2.0, Vec3d{0, 0.5, 2}, 2 * cells), {0.9f, 0.9f, 0.9f});
  return builder;
}

// Irradiance over pi that the scene's lights cause, per vertex.
std::vector<double> received(const Scene& scene, const Bake& bake) {
  std::vector<double> result(scene.mesh.positions.size());
  for (std::size_t v = 0; v < result.size(); ++v) {
    const SurfaceMaterial& material = scene.materials[scene.mesh.vertexMaterials[v]];
    result[v] = static_cast<double>(bake.emission[v].x - material.emission.x) /
                static_cast<double>(scene.albedo[v].x);
  }
  return result;
}

struct PartPower {
  double power = 0,
         largestVariance = 0;  // of a mean over rays whose single ray has a variance of at most 1/4
};

PartPower powerOn(const test::SceneBuilder& builder, std::size_t part, int rays, std::optional<int> bounces) {
  const Scene scene = builder.build();
  const Bake bake =
      bakeInterreflected(scene, {.degree = 0, .rays = rays, .seed = 1, .bounces = bounces, .error = 1e-4});
  const std::vector<double> areas = test::vertexAreas(scene.mesh), radiance = received(scene, bake);
  PartPower result;
  for (std::size_t v = builder.start(part); v < builder.start(part + 1); ++v) {
    result.power += areas[v] * radiance[v];
    result.largestVariance += areas[v] * areas[v] * radiance[v] * (1 - std::min(radiance[v], 1.0)) / rays;
  }
  return result;
}

// What a radiance of 1 on A sends to B is what a radiance of 1 on B sends to A: of the form factors times
// areas, and of any number of bounces. Rays are as good as random ones at least, whose variance a ray's
// values between 0 and 1 bound. Lumped vertex areas integrate over flat faces to second order in the cells.
TEST(TruthOperator, Reciprocity) {
  const int cells = 8, rays = 1024;
  for (const std::optional<int> bounces :
       {std::optional<int>(0), std::optional<int>(1), std::optional<int>()}) {
    const PartPower onSecond = powerOn(twoBoxes(cells, 1), 2, rays, bounces),
                    onFirst = powerOn(twoBoxes(cells, 2), 1, rays, bounces);
    EXPECT_GT(onFirst.power, 0.01);
    const double sigma = std::sqrt(onFirst.largestVariance + onSecond.largestVariance);
    const double quadrature = 0.01 * onFirst.power;
    EXPECT_NEAR(onFirst.power, onSecond.power, 3 * sigma + quadrature)
        << "bounces " << (bounces ? std::to_string(*bounces) : "auto") << ", sigma " << sigma;
  }
}

// Each vertex gathers an average of what its hits send out, so the brightest vertex of bounce k + 1 is at
// most the largest albedo times the brightest of bounce k: exactly, but for the float sums that are
// subtracted. Power may not grow either, but for the quadrature by lumped areas.
TEST(TruthOperator, EnergyNeverGrows) {
  Mesh room = test::makeRoomWithWindow(8);
  const std::vector<double> areas = test::vertexAreas(room);
  const float albedo = 0.9f;
  const Scene scene = test::grey(room, albedo);
  std::vector<double> before, last;
  double brightestBefore = 0, powerBefore = 0;
  for (int bounces = 0; bounces <= 5; ++bounces) {
    const Bake bake = bakeInterreflected(scene, {.degree = 0, .rays = 512, .seed = 1, .bounces = bounces});
    double brightest = 0, power = 0;
    std::vector<double> sum(areas.size());
    for (std::size_t v = 0; v < sum.size(); ++v) {
      sum[v] = static_cast<double>(bake.transfer.row(0, 0)[v]) * std::sqrt(4 * pi);
      const double added = bounces == 0 ? sum[v] : sum[v] - before[v];
      EXPECT_GE(added, -1e-6) << v;
      brightest = std::max(brightest, added);
      power += areas[v] * added;
    }
    if (bounces > 0) {
      EXPECT_LE(brightest, static_cast<double>(albedo) * brightestBefore + 1e-6) << bounces;
      // Some of the light leaves through the window.
      EXPECT_LT(power, static_cast<double>(albedo) * powerBefore) << bounces;
    }
    before = sum, brightestBefore = brightest, powerBefore = power;
  }
}

// In a closed room nothing leaves: power per bounce falls by the albedo, neither more nor less, whatever the
// light's place. Corner vertices hold as much area as they see.
TEST(TruthOperator, ClosedRoomKeepsAllPower) {
  test::SceneBuilder builder;
  builder.add(test::makeRoom({0, 0, 0}, {1, 1, 1}, 12), {0.8f, 0.8f, 0.8f});
  builder.add(test::makePatch({0.3, 0.9, 0.3}, kX * 0.4, kZ * 0.4, 2), {0.8f, 0.8f, 0.8f}, {1, 1, 1});
  const Scene scene = builder.build();
  const std::vector<double> areas = test::vertexAreas(scene.mesh);
  std::vector<double> before;
  double powerBefore = 0;
  for (int bounces = 0; bounces <= 3; ++bounces) {
    const Bake bake = bakeInterreflected(scene, {.degree = 0, .rays = 512, .seed = 1, .bounces = bounces});
    const std::vector<double> sum = received(scene, bake);
    double power = 0;
    for (std::size_t v = 0; v < sum.size(); ++v) power += areas[v] * (sum[v] - (bounces ? before[v] : 0));
    // 0.16 of light spread over the panel's cosine lobe; all of it lands somewhere.
    if (bounces == 0) {
      EXPECT_NEAR(power, 0.16, 0.02 * 0.16);
    } else {
      // The panel's black back absorbs its form factor's share of what the ceiling sends down.
      EXPECT_LT(power, 0.8 * powerBefore * 1.01) << bounces;
      EXPECT_GT(power, 0.8 * powerBefore * 0.9) << bounces;
    }
    before = sum, powerBefore = power;
  }
}

}  // namespace
}  // namespace shprt
