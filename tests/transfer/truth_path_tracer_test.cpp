// Interreflected transfer against the path tracer, at random vertices of whole scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>

#include "shprt/mesh/load_mesh.h"
#include "shprt/sampling/random.h"
#include "shprt/transfer/bake.h"
#include "tests/transfer/path_tracer.h"
#include "tests/transfer/truth_meshes.h"

namespace shprt {
namespace {

// Vertices per scene, walks of the path tracer and rays of the bake at each.
#ifdef SHPRT_LONG_TESTS
constexpr int kVertices = 400, kPaths = 65536, kRays = 8192;
#else
constexpr int kVertices = 40, kPaths = 4096, kRays = 1024;
#endif

double component(Vec3d a, int channel) {
  return channel == 0 ? a.x : channel == 1 ? a.y : a.z;
}

double largestOf(Vec3d a) {
  return std::max({a.x, a.y, a.z});
}

struct Agreement {
  int coefficients = 0, outside = 0;         // beyond three standard errors
  double meanShift = 0, meanShiftError = 0;  // of the first coefficient, relative to unshadowed
  // RMS over vertices and channels of a vertex's 2-norm, relative to that of the unshadowed transfer, the
  // path tracer's noise taken out.
  double distance = 0;
};

// allowance: for interpolation between vertices, in units of an open vertex's first coefficient.
Agreement compare(const Scene& scene, const InterreflectedOptions& options, double allowance) {
  const Bake bake = bakeInterreflected(scene, options);
  const test::PathTracer tracer(scene);
  const std::uint64_t count = scene.mesh.positions.size();
  const double first = std::sqrt(1 / (4 * std::numbers::pi));
  Agreement result;
  double squares = 0, noise = 0;
  int cases = 0;
  for (std::uint64_t draw = 0; cases < kVertices; ++draw) {
    const auto vertex = static_cast<std::uint32_t>(uniformRandom(17, draw, 0) * static_cast<double>(count));
    // Filled from around them in a bake.
    if (tracer.buriedShare(vertex) == 1) continue;
    // So are those behind a coinciding front, which the share does not tell. No light finds its way to them,
    // as it does to all else in these scenes.
    constexpr std::optional<int> kEndless;
    if (largestOf(tracer.atVertex(vertex, {.degree = 0, .paths = 512, .seed = 23, .bounces = kEndless})
                      .transfer[0]) == 0)
      continue;
    const Vec3f albedo = scene.albedo[vertex];
    const test::PathEstimate truth = tracer.atVertex(
        vertex, {.degree = options.degree, .paths = kPaths, .seed = 23, .bounces = options.bounces});
    ++cases;
    for (int channel = 0; channel < bake.transfer.channels; ++channel)
      for (int i = 0; i < coefficientCount(options.degree); ++i) {
        const double share = component(toDouble(albedo), channel);
        if (share == 0) continue;
        const double baked = static_cast<double>(bake.transfer.row(channel, i)[vertex]) / share;
        const double error = component(truth.transferError[static_cast<std::size_t>(i)], channel);
        const double difference = baked - component(truth.transfer[static_cast<std::size_t>(i)], channel);
        squares += difference * difference / bake.transfer.channels;
        noise += error * error / bake.transfer.channels;
        ++result.coefficients;
        // Where no walk found the sky, its standard error is not zero but unknown: three in kPaths may.
        const double unseen = 3.0 / kPaths;
        if (std::abs(difference) > 3 * error + (allowance + unseen) * first) ++result.outside;
        if (i == 0) {
          result.meanShift += difference / first / bake.transfer.channels;
          result.meanShiftError += error * error / (first * first) / bake.transfer.channels;
        }
      }
  }
  // The unshadowed transfer's 2-norm: sqrt of the sum over l of (A_l / pi)^2 (2l + 1) / 4 pi.
  const Bake unshadowed =
      bakeUnshadowed(test::grey(test::makePatch({}, test::kX, test::kZ, 1), 1), options.degree);
  double norm = 0;
  for (int i = 0; i < coefficientCount(options.degree); ++i)
    norm += std::pow(static_cast<double>(unshadowed.transfer.row(0, i)[0]), 2);
  result.distance = std::sqrt(std::max(squares - noise, 0.0) / cases / norm);
  result.meanShift /= cases;
  result.meanShiftError = std::sqrt(result.meanShiftError) / cases;
  return result;
}

// 0.27% of normal deviates are beyond three standard errors. Coefficients of one vertex are drawn together,
// so three times as many are let pass, and half of those of one vertex that interpolation may move, as where
// three surfaces meet.
void expectAgreement(const Agreement& found, const std::string& what, double allowance) {
  const std::string figures =
      what + ": " + std::to_string(found.outside) + " of " + std::to_string(found.coefficients) +
      " outside, mean shift " + std::to_string(found.meanShift) + " +- " +
      std::to_string(found.meanShiftError) + ", distance " + std::to_string(found.distance);
  EXPECT_LE(found.outside, 0.0081 * found.coefficients + 8) << figures;
  EXPECT_LE(std::abs(found.meanShift), 3 * found.meanShiftError + allowance) << figures;
  testing::Test::RecordProperty("figures", figures);
  if (std::getenv("SHPRT_TRUTH_FIGURES")) std::puts(figures.c_str());
}

TEST(TruthPathTracer, CornellBox) {
  const Scene scene = test::makeCornellBox(12);
  for (const std::optional<int> bounces :
       {std::optional<int>(0), std::optional<int>(1), std::optional<int>()}) {
    const double allowance = bounces == 0 ? 0.002 : 0.01;
    const Agreement found =
        compare(scene, {.degree = 3, .rays = kRays, .seed = 1, .bounces = bounces, .error = 1e-3}, allowance);
    expectAgreement(found, "Cornell box, bounces " + (bounces ? std::to_string(*bounces) : "auto"),
                    allowance);
  }
}

Scene load(const std::string& file, float albedo) {
  LoadedMesh loaded = loadMesh(std::filesystem::path(SHPRT_SOURCE_DIR) / "data" / file);
  return test::grey(loaded.mesh, albedo);
}

TEST(TruthPathTracer, Courtyard) {
  for (const std::optional<int> bounces : {std::optional<int>(0), std::optional<int>()}) {
    const double allowance = bounces == 0 ? 0.002 : 0.01;
    const Agreement found =
        compare(load("courtyard.obj", 0.8f),
                {.degree = 3, .rays = kRays, .seed = 1, .bounces = bounces, .error = 1e-3}, allowance);
    expectAgreement(found, "courtyard, bounces " + (bounces ? std::to_string(*bounces) : "auto"), allowance);
  }
}

TEST(TruthPathTracer, Knot) {
  for (const std::optional<int> bounces : {std::optional<int>(0), std::optional<int>()}) {
    const double allowance = bounces == 0 ? 0.002 : 0.01;
    const Agreement found =
        compare(load("knot.ply", 0.8f),
                {.degree = 3, .rays = kRays / 4, .seed = 1, .bounces = bounces, .error = 1e-3}, allowance);
    expectAgreement(found, "knot, bounces " + (bounces ? std::to_string(*bounces) : "auto"), allowance);
  }
}

}  // namespace
}  // namespace shprt
