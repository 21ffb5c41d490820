// Fitted bakes against what is true inside the triangles.
#include "shprt/transfer/fitted.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "shprt/transfer/sample_transfer.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

constexpr Vec3d kX{1, 0, 0}, kZ{0, 0, 1};
constexpr int kDegree = 3;

// What can be seen of the surface: RMS over its area of the 2-norm of interpolated transfer minus truth, at
// samples of which the fit knows nothing.
class Truth {
 public:
  explicit Truth(const Scene& scene, int rays = 256) : scene_(scene) {
    const PreparedScene prepared(scene);
    samples_ = sampleSurface(scene, prepared.topology, {.perTriangle = 32, .minimum = 8, .seed = 1234});
    SampleTransfer measured = bakeSamples(prepared, samples_, {.degree = kDegree, .rays = rays, .seed = 99});
    removeSamples(measured.buried, samples_, measured.transfer);
    values_ = std::move(measured.transfer);
  }

  double errorOf(const TransferCoefficients& transfer) const {
    double squares = 0, area = 0;
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      const auto& [a, b, c] = scene_.mesh.triangles[samples_[s].triangle];
      const float u = samples_[s].u, v = samples_[s].v;
      for (int i = 0; i < transfer.rows(); ++i) {
        const float* row = transfer.row(0, i);
        const double error = static_cast<double>(row[a] * (1 - u - v) + row[b] * u + row[c] * v -
                                                 values_.at(s)[static_cast<std::size_t>(i)]);
        squares += samples_[s].weight * error * error;
      }
      area += samples_[s].weight;
    }
    return std::sqrt(squares / area);
  }

 private:
  const Scene& scene_;
  std::vector<SurfaceSample> samples_;
  SampleValues values_;
};

TEST(Fitted, ShadowOnACoarseFloorComesNearerToTheTruth) {
  // A box hovers over the middle of a floor whose vertices are farther apart than the box is wide. With an
  // even number of cells a vertex lies right below it and exaggerates the shadow; with an odd one all
  // vertices miss it.
  for (const int cells : {4, 5}) {
    Mesh mesh = test::makeBox({-0.3, 0.2, -0.3}, {0.6, 0.4, 0.6}, 1);
    test::addPatch(mesh, {-2, 0, -2}, kZ * 4, kX * 4, cells);
    const Scene scene = test::grey(mesh, 1);
    const Truth truth(scene);
    const ShadowedOptions shadowed{.degree = kDegree, .rays = 256, .seed = 1};
    const double atVertices = truth.errorOf(bakeShadowed(scene, shadowed).transfer);
    const FittedBake fitted = bakeFitted(scene, shadowed, {});
    EXPECT_TRUE(fitted.fit.converged);
    EXPECT_LT(truth.errorOf(fitted.bake.transfer), 0.9 * atVertices) << cells << " cells";
    EXPECT_EQ(fitted.bake.statistics.rays, 256 * fitted.bake.statistics.samplePoints);
  }
}

TEST(Fitted, NoVertexSeesLessThanNothingOrMoreThanAll) {
  // A plate just above a floor's middle vertex: the step from dark to bright around it makes least squares
  // overshoot on both sides.
  Mesh mesh = test::makeBox({-0.5, 0.01, -0.5}, {1, 0.1, 1}, 1);
  const std::size_t floorVertex = mesh.positions.size();
  test::addPatch(mesh, {-2, 0, -2}, kZ * 4, kX * 4, 4);
  const Scene scene = test::grey(mesh, 1);
  const ShadowedOptions shadowed{.degree = kDegree, .rays = 64, .seed = 1};
  const FittedBake fitted = bakeFitted(scene, shadowed, {.samples = {.perTriangle = 16}});
  float least = 1, greatest = 0;
  for (std::size_t vertex = floorVertex; vertex < mesh.positions.size(); ++vertex) {
    const float share = fitted.bake.transfer.row(0, 0)[vertex] * std::sqrt(4 * std::numbers::pi_v<float>);
    least = std::min(least, share);
    greatest = std::max(greatest, share);
  }
  EXPECT_NEAR(least, 0, 1e-6);
  EXPECT_NEAR(greatest, 1, 1e-6);
}

TEST(Fitted, DarknessInsideASolidStaysThere) {
  // A low box stands on a floor and covers most of one of its cells. Seen from outside, the floor around it
  // is nearly unshadowed; the dark part below the box must not drag the corners of that cell down.
  Mesh mesh;
  test::addPatch(mesh, {-1.5, 0, -1.5}, kZ * 3, kX * 3, 3);
  test::append(mesh, test::makeBox({-0.4, 0, -0.4}, {0.8, 0.02, 0.8}, 1));
  const Scene scene = test::grey(mesh, 1);
  const FittedBake fitted = bakeFitted(scene, {.degree = kDegree, .rays = 256, .seed = 1},
                                       {.samples = {.perTriangle = 8, .minimum = 64, .seed = 1}});
  EXPECT_GT(fitted.buriedSamples, 40u);  // of 128 in that cell, 64 % on average
  // A wall of height h hides at most (1 - d / sqrt(d^2 + h^2)) / 2 at distance d: less than 5 % beyond 2 h.
  const double unshadowed = 1 / std::sqrt(4 * std::numbers::pi);
  for (std::size_t vertex = 0; vertex < 16; ++vertex)
    EXPECT_NEAR(fitted.bake.transfer.row(0, 0)[vertex] / unshadowed, 1, 0.1) << vertex;
}

TEST(Fitted, CoarseBallsAreUnshadowedWithinTheInterpolationError) {
  for (const int subdivisions : {1, 2}) {
    const Scene scene = test::grey(test::makeIcosphere(subdivisions), 1);
    const Truth truth(scene, 16);  // exact with any number of rays
    const FittedBake fitted =
        bakeFitted(scene, {.degree = kDegree, .rays = 16, .seed = 1}, {.samples = {.perTriangle = 32}});
    const double interpolation = truth.errorOf(bakeUnshadowed(scene, kDegree).transfer);
    EXPECT_LT(truth.errorOf(fitted.bake.transfer), interpolation) << subdivisions;
    EXPECT_EQ(fitted.bake.statistics.meanVisibility, 1);
    EXPECT_EQ(fitted.buriedSamples, 0u);
  }
}

TEST(Fitted, AlbedoIsTheVerticesOwnAndBlockersAreLeftOut) {
  Mesh mesh;
  test::addPatch(mesh, {-1, 0, -1}, kZ * 2, kX * 2, 2);
  const auto receivers = static_cast<std::uint32_t>(mesh.positions.size());
  test::addPatch(mesh, {-0.5, 0.5, -0.5}, kX, kZ);
  const auto make = [&](std::vector<Vec3f> albedo) {
    Scene scene = makeScene(mesh, std::move(albedo));
    scene.objects.push_back({.name = "lid", .file = "", .role = Role::kBlocker, .report = {}});
    for (std::uint32_t v = receivers; v < mesh.positions.size(); ++v) scene.vertexObjects[v] = 1;
    return scene;
  };
  std::vector<Vec3f> coloured(mesh.positions.size(), Vec3f{0.5f, 0.25f, 0.75f});
  coloured[3] = {};
  const ShadowedOptions shadowed{.degree = kDegree, .rays = 64, .seed = 1};
  const Bake white =
      bakeFitted(make(std::vector<Vec3f>(mesh.positions.size(), Vec3f{1, 1, 1})), shadowed, {}).bake;
  const Bake bake = bakeFitted(make(coloured), shadowed, {}).bake;
  ASSERT_EQ(bake.transfer.channels, 3);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    for (int i = 0; i < bake.transfer.rows(); ++i) {
      const float expected = v < receivers ? white.transfer.row(0, i)[v] : 0.0f;
      EXPECT_FLOAT_EQ(bake.transfer.row(1, i)[v], coloured[v].y * expected);
    }
  EXPECT_LT(white.transfer.row(0, 0)[4], white.transfer.row(0, 0)[0]) << "the lid shades the middle";
}

}  // namespace
}  // namespace shprt
