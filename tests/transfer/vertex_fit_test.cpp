// Fits whose result is known: fields that interpolation can represent, and what the regulariser may change.
#include "shprt/transfer/vertex_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shprt/base/parallel.h"
#include "shprt/sampling/random.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

struct Problem {
  Scene scene;
  SurfaceTopology topology;
  std::vector<SurfaceSample> samples;

  Problem(const Mesh& mesh, double perTriangle)
      : scene(test::grey(mesh, 1)),
        topology(scene.mesh),
        samples(sampleSurface(scene, topology, {.perTriangle = perTriangle, .minimum = 1, .seed = 1})) {}

  std::size_t vertexCount() const { return scene.mesh.positions.size(); }

  // What samples read of a field given at the vertices, one row.
  SampleValues interpolated(std::span<const float> field) const {
    SampleValues values{1, {}};
    for (const SurfaceSample& sample : samples) {
      const auto& [a, b, c] = scene.mesh.triangles[sample.triangle];
      values.values.push_back(field[a] * (1 - sample.u - sample.v) + field[b] * sample.u +
                              field[c] * sample.v);
    }
    return values;
  }
  VertexFit fit(const SampleValues& values, const FitOptions& options) const {
    return fitToSamples(topology, samples, values, std::vector<float>(vertexCount() * values.rows), options);
  }
};

std::vector<float> noise(std::size_t count, std::uint64_t seed = 5) {
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<float>(uniformRandom(seed, i, 0));
  return values;
}

float largestDifference(std::span<const float> a, std::span<const float> b) {
  float largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

Mesh patch(int cells) {
  Mesh mesh;
  test::addPatch(mesh, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, cells);
  return mesh;
}

TEST(VertexFit, RecoversWhateverInterpolationCanRepresent) {
  const Problem problem(test::makeIcosphere(2), 8);
  const std::vector<float> field = noise(problem.vertexCount());
  const VertexFit fit =
      problem.fit(problem.interpolated(field), {.alpha = 0, .tolerance = 1e-8, .maximumIterations = 1000});
  EXPECT_TRUE(fit.converged);
  EXPECT_LT(largestDifference(fit.values, field), 1e-5f);
  EXPECT_LT(fit.sampleDistance, 1e-6);
  EXPECT_EQ(fit.fittedVertices, problem.vertexCount());
}

TEST(VertexFit, LinearFieldsStayUnderAnyRegulariser) {
  Mesh mesh = patch(7);
  // Uneven, so that nothing cancels by symmetry.
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.positions[v].x += 0.04f * static_cast<float>(uniformRandom(1, v, 0));
    mesh.positions[v].z += 0.04f * static_cast<float>(uniformRandom(1, v, 1));
  }
  const Problem problem(mesh, 4);
  std::vector<float> field;
  for (const Vec3f& p : mesh.positions) field.push_back(0.3f + 0.5f * p.x - 0.8f * p.z);
  for (const double alpha : {0.0, 0.01, 1.0, 100.0}) {
    const VertexFit fit = problem.fit(problem.interpolated(field),
                                      {.alpha = alpha, .tolerance = 1e-9, .maximumIterations = 5000});
    EXPECT_LT(largestDifference(fit.values, field), 2e-5f) << alpha;
  }
}

TEST(VertexFit, ConstantFieldsStayUnderAnyRegulariserOnCurvedMeshes) {
  const Problem problem(test::makeIcosphere(2), 4);
  const std::vector<float> field(problem.vertexCount(), 0.7f);
  for (const double alpha : {0.0, 0.01, 1.0, 100.0}) {
    const VertexFit fit = problem.fit(problem.interpolated(field),
                                      {.alpha = alpha, .tolerance = 1e-9, .maximumIterations = 5000});
    EXPECT_LT(largestDifference(fit.values, field), 1e-5f) << alpha;
  }
}

TEST(VertexFit, MinimisesItsFunctionalOnAFlap) {
  // A unit square of two triangles, heights equal: the bracket is (a + c)/2 - (b + d)/2 over the diagonal ac,
  // its weight alpha / 3. One sample per corner of each triangle, each standing for 1/6: corners on the
  // diagonal have weight 1/3, the others 1/6. With values 1 at b and d, 0 at a and c, and symmetry a = c = s,
  // b = d = t, the minimum of 2/3 s^2 + 1/3 (t - 1)^2 + alpha/3 (s - t)^2 is
  // t = (2 + alpha) / (2 + 3 alpha), s = alpha / (2 + 3 alpha).
  Problem problem(patch(1), 1);
  problem.samples.clear();
  SampleValues values{1, {}};
  const std::uint32_t diagonal[2] = {0, 3};
  for (std::uint32_t t = 0; t < 2; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      problem.samples.push_back({t, k == 1 ? 1.0f : 0.0f, k == 2 ? 1.0f : 0.0f, 1.0 / 6});
      const std::uint32_t vertex = problem.scene.mesh.triangles[t][k];
      values.values.push_back(vertex == diagonal[0] || vertex == diagonal[1] ? 0.0f : 1.0f);
    }
  for (const double alpha : {0.0, 0.1, 1.0, 10.0}) {
    const VertexFit fit = problem.fit(values, {.alpha = alpha, .tolerance = 1e-10, .maximumIterations = 100});
    EXPECT_NEAR(fit.values[0], alpha / (2 + 3 * alpha), 1e-6) << alpha;
    EXPECT_NEAR(fit.values[3], alpha / (2 + 3 * alpha), 1e-6) << alpha;
    EXPECT_NEAR(fit.values[1], (2 + alpha) / (2 + 3 * alpha), 1e-6) << alpha;
    EXPECT_NEAR(fit.values[2], (2 + alpha) / (2 + 3 * alpha), 1e-6) << alpha;
  }
}

TEST(VertexFit, RegulariserDecidesOnlyWhereSamplesAreSilent) {
  // A field that bends along x = 0.5 and is linear on either side. All samples that could tell the value of
  // one vertex in the linear part read it with barycentric 1e-3 only, and lie: that vertex alone follows its
  // surroundings instead.
  Problem problem(patch(8), 32);
  const auto& positions = problem.scene.mesh.positions;
  std::vector<float> field;
  for (const Vec3f& p : positions) field.push_back(std::max(p.x - 0.5f, 0.0f) + 0.2f * p.z);
  const std::uint32_t silent = 2 * 9 + 6;  // at z = 0.25, x = 0.75
  ASSERT_EQ(positions[silent], (Vec3f{0.75f, 0, 0.25f}));
  std::vector<float> lying = field;
  lying[silent] += 5;
  for (SurfaceSample& sample : problem.samples) {
    const Triangle& t = problem.scene.mesh.triangles[sample.triangle];
    const auto corner = std::find(t.begin(), t.end(), silent) - t.begin();
    if (corner == 0) sample.u = 0.999f - sample.v * 0.999f, sample.v *= 0.999f;
    if (corner == 1) sample.u = 0.001f, sample.v *= 0.999f;
    if (corner == 2) sample.v = 0.001f, sample.u *= 0.999f;
  }
  const SampleValues values = problem.interpolated(lying);
  const auto error = [&](double alpha) {
    const VertexFit fit = problem.fit(values, {.alpha = alpha, .tolerance = 1e-9, .maximumIterations = 5000});
    std::pair<float, float> errors{fit.values[silent] - field[silent], 0};
    for (std::size_t v = 0; v < field.size(); ++v)
      if (v != silent) errors.second = std::max(errors.second, std::abs(fit.values[v] - field[v]));
    return errors;
  };
  EXPECT_NEAR(error(0).first, 5, 0.05);
  const auto [atSilent, elsewhere] = error(0.01);
  EXPECT_LT(std::abs(atSilent), 0.05f);
  EXPECT_LT(elsewhere, 0.01f);
}

TEST(VertexFit, HardEdgesStayHardAndSeamsClosed) {
  // Each face of a box has its own value; no regulariser reaches across its edges.
  Mesh box = test::makeBox({-1, -1, -1}, {2, 2, 2}, 2);
  std::vector<float> field;
  for (const Vec3f& n : box.normals) field.push_back(n.x + 2 * n.y + 3 * n.z);
  const Problem faces(box, 4);
  EXPECT_LT(largestDifference(faces.fit(faces.interpolated(field), {.alpha = 10}).values, field), 1e-4f);

  // Two patches that differ in nothing but their render vertices along x = 0.5 are one surface.
  Mesh seam;
  test::addPatch(seam, {0, 0, 0}, {0, 0, 1}, {0.5, 0, 0}, 2);
  test::addPatch(seam, {0.5, 0, 0}, {0, 0, 1}, {0.5, 0, 0}, 2);
  const Problem halves(seam, 16);
  const VertexFit fit = halves.fit(halves.interpolated(noise(halves.vertexCount())), {});
  int shared = 0;
  for (std::size_t a = 0; a < 9; ++a)
    for (std::size_t b = 9; b < 18; ++b) {
      if (!(seam.positions[a] == seam.positions[b])) continue;
      EXPECT_EQ(fit.values[a], fit.values[b]);
      ++shared;
    }
  EXPECT_EQ(shared, 3);
}

TEST(VertexFit, VerticesWithoutSamplesKeepTheirStart) {
  Problem problem(patch(4), 4);
  std::erase_if(problem.samples, [](const SurfaceSample& sample) { return sample.triangle >= 8; });
  const std::vector<float> field(problem.vertexCount(), 1), start = noise(problem.vertexCount());
  const VertexFit fit =
      fitToSamples(problem.topology, problem.samples, problem.interpolated(field), start, {});
  for (std::size_t v = 0; v < 10; ++v) EXPECT_NEAR(fit.values[v], 1, 1e-4);
  for (std::size_t v = 10; v < field.size(); ++v) EXPECT_EQ(fit.values[v], start[v]);
  EXPECT_EQ(fit.fittedVertices, 10u);
}

TEST(VertexFit, ConvergesOnTenThousandVerticesWithTheSameBitsForAnyNumberOfThreads) {
  const Problem problem(patch(100), 4);
  const std::vector<float> field = noise(problem.vertexCount());
  SampleValues values{5, {}};  // one row more than a group holds
  for (const float value : problem.interpolated(field).values)
    for (int row = 0; row < 5; ++row)
      values.values.push_back(row == 2 ? 0 : value * static_cast<float>(row + 1));
  const FitOptions options;
  setThreadCount(1);
  const VertexFit one = problem.fit(values, options);
  setThreadCount(0);
  const VertexFit many = problem.fit(values, options);
  EXPECT_EQ(one.values, many.values);
  EXPECT_TRUE(one.converged);
  EXPECT_LE(one.residual, 2 * options.tolerance);
  EXPECT_GT(one.iterations, 1);
  EXPECT_LT(one.iterations, options.maximumIterations);
  // Rows do not disturb each other: multiples of a field give multiples of its fit, zero gives zero.
  const std::span<const float> fitted = one.values;
  const std::size_t n = problem.vertexCount();
  for (std::size_t v = 0; v < n; ++v) {
    ASSERT_NEAR(fitted[4 * n + v], 5 * fitted[v], 1e-3);
    ASSERT_EQ(fitted[2 * n + v], 0);
  }
  const VertexFit capped = problem.fit(values, {.maximumIterations = 2});
  EXPECT_EQ(capped.iterations, 2);
  EXPECT_FALSE(capped.converged);
}

}  // namespace
}  // namespace shprt
