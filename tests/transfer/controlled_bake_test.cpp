// Bakes that tell their own error keep to it: over seeds and scenes, against bakes of many rays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "shprt/base/parallel.h"
#include "shprt/scene/load_scene.h"
#include "shprt/transfer/planned_bake.h"
#include "shprt/transfer/transfer_rows.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

#ifdef SHPRT_LONG_TESTS
constexpr int kReferenceRays = 65536, kSeeds = 40;
#else
constexpr int kReferenceRays = 16384, kSeeds = 6;
#endif

struct Case {
  std::string name, model;
  Scene scene;
};

Scene ballOverFloor() {
  Mesh mesh;
  test::addPatch(mesh, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0}, 12);
  test::append(mesh, test::moved(test::makeIcosphere(2), 0.6, {0.1, 0.8, 0}));
  return test::grey(mesh, 0.8f);
}

Scene boxesInRow() {
  Mesh mesh = test::makeBox({-1, 0, -1}, {0.8, 1.5, 0.8}, 4);
  test::append(mesh, test::makeBox({0.2, 0, -0.7}, {0.8, 0.7, 0.8}, 4));
  test::addPatch(mesh, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0}, 9);
  return test::grey(mesh, 0.6f);
}

std::vector<Case> cases() {
#ifdef __SANITIZE_ADDRESS__  // looks at the same lines ten times slower
  return {{"boxes", "interreflected", boxesInRow()}};
#else
  return {{"ball", "shadowed", ballOverFloor()},
          {"boxes", "shadowed", boxesInRow()},
          {"ball", "interreflected", ballOverFloor()},
          {"courtyard", "interreflected", loadScene(SHPRT_SOURCE_DIR "/data/courtyard.obj", {})}};
#endif
}

double rms(const TransferCoefficients& a, const TransferCoefficients& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    sum += std::pow(static_cast<double>(a.values[i]) - static_cast<double>(b.values[i]), 2);
  return std::sqrt(sum);
}

// The truth of one scene, which must outlive it, and the measure of docs/accuracy.md.
class Truth {
 public:
  explicit Truth(const Case& what) : prepared_(what.scene), model_(what.model) {
    BakeRequest many = request(999);
    many.rays = kReferenceRays;
    reference_ = bakeRequested(prepared_, many).transfer;
    TransferCoefficients unshadowed = bakeUnshadowed(what.scene, many.degree).transfer;
    scale_ = rms(unshadowed, makeTransfer(unshadowed.channels, unshadowed.vertexCount, many.degree));
  }

  BakeRequest request(std::uint64_t seed) const {
    return {.model = model_, .degree = 3, .seed = seed, .bounces = {}, .error = 1e-4};
  }
  Bake bake(const BakeRequest& asked) const { return bakeRequested(prepared_, asked); }
  double errorOf(const Bake& bake) const { return rms(bake.transfer, reference_) / scale_; }
  const TransferCoefficients& reference() const { return reference_; }

 private:
  PreparedScene prepared_;
  std::string model_;
  TransferCoefficients reference_;
  double scale_;
};

TEST(ControlledBake, ToldErrorsAreTrueOverSeeds) {
  for (const Case& what : cases()) {
    const Truth truth(what);
    for (const int rays : {64, 256}) {
      double told = 0, real = 0;
      int beyond = 0;
      for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        BakeRequest asked = truth.request(seed);
        asked.rays = rays;
        asked.measureError = true;
        const Bake bake = truth.bake(asked);
        const double error = truth.errorOf(bake);
        told += std::pow(bake.statistics.sampling.error, 2), real += error * error;
        beyond += error > bake.statistics.sampling.errorBound;
      }
      const double ratio = std::sqrt(told / real);
      const std::string where = what.name + ", " + what.model + ", " + std::to_string(rays) + " rays";
      EXPECT_GE(ratio, 0.97) << where;
      EXPECT_LE(ratio, 1.6) << where;
      // One in 20, and what chance allows so few seeds.
      EXPECT_LE(beyond, 1 + kSeeds / 8) << where;
    }
  }
}

TEST(ControlledBake, ReachesTheErrorAskedForAndLittleLess) {
  for (const Case& what : cases()) {
    const Truth truth(what);
    for (const double error : {0.04, 0.015}) {
      int beyond = 0;
      for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        BakeRequest asked = truth.request(seed);
        asked.samplingError = error;
        const Bake bake = truth.bake(asked);
        const SamplingStatistics& sampling = bake.statistics.sampling;
        const double reached = truth.errorOf(bake);
        EXPECT_LE(sampling.errorBound, error) << what.name;
        EXPECT_LE(sampling.error, sampling.errorBound) << what.name;
        EXPECT_GE(reached, 0.3 * error) << what.name << ' ' << what.model << " seed " << seed;
        beyond += reached > error;
      }
      EXPECT_LE(beyond, 1 + kSeeds / 10) << what.name << ' ' << what.model << ' ' << error;
    }
  }
}

// Per vertex the standard error is known from few numbers; over all of them, errors in its units have RMS 1.
TEST(ControlledBake, StandardErrorsOfVerticesFitTheirErrors) {
  const Case what{"ball", "shadowed", ballOverFloor()};
  const Truth truth(what);
  BakeRequest asked = truth.request(3);
  asked.samplingError = 0.03;
  const Bake bake = truth.bake(asked);
  const TransferError& error = bake.error;
  ASSERT_EQ(error.degree, 3);
  ASSERT_EQ(error.vertexCount, bake.transfer.vertexCount);
  std::vector<double> deviates;
  for (std::size_t vertex = 0; vertex < error.vertexCount; ++vertex) {
    double expected = 0, real = 0;
    for (int band = 0; band <= error.degree; ++band) expected += std::pow(error.row(0, band)[vertex], 2);
    for (int i = 0; i < bake.transfer.rows(); ++i)
      real += std::pow(bake.transfer.row(0, i)[vertex] - truth.reference().row(0, i)[vertex], 2);
    if (expected == 0) {
      EXPECT_EQ(real, 0) << vertex;
      continue;
    }
    deviates.push_back(std::sqrt(real / expected));
  }
  ASSERT_GT(deviates.size(), 100u);
  std::sort(deviates.begin(), deviates.end());
  EXPECT_GT(deviates[deviates.size() / 2], 0.4);
  EXPECT_LT(deviates[deviates.size() / 2], 1.2);
  EXPECT_LT(deviates[deviates.size() * 95 / 100], 3);
}

TEST(ControlledBake, ConvexScenesAreExactAndTakeNoRays) {
  const Scene scene = test::grey(test::makeIcosphere(3), 0.8f);
  BakeRequest asked{.model = "shadowed", .degree = 4};
  asked.samplingError = 0.001;
  const Bake bake = bakeRequested(PreparedScene(scene), asked);
  EXPECT_EQ(bake.transfer.values, bakeUnshadowed(scene, 4).transfer.values);
  const SamplingStatistics& sampling = bake.statistics.sampling;
  EXPECT_EQ(sampling.errorBound, 0);
  EXPECT_EQ(sampling.passes.size(), 1u);
  ASSERT_EQ(sampling.verticesByRays.size(), 1u);
  EXPECT_EQ(sampling.verticesByRays[0].first, 0);
  EXPECT_EQ(sampling.verticesByRays[0].second, scene.mesh.positions.size());
}

TEST(ControlledBake, SendsRaysWhereShadowsAre) {
  Mesh mesh;
  test::addPatch(mesh, {-50, 0, -50}, {0, 0, 100}, {100, 0, 0}, 40);
  const std::size_t field = mesh.positions.size();
  test::append(mesh, test::moved(test::makeIcosphere(3), 0.6, {0, 0.8, 0}));
  test::append(mesh, test::moved(test::makeIcosphere(3), 0.6, {1.3, 0.8, 0}));
  const Scene scene = test::grey(mesh, 0.8f);
  BakeRequest asked{.model = "shadowed", .degree = 3};
  asked.samplingError = 0.002;
  const SamplingStatistics sampling = bakeRequested(PreparedScene(scene), asked).statistics.sampling;
  // The many vertices of the field, nearly all of them far away, take the least classes.
  std::uint64_t few = 0;
  for (const auto& [rays, vertices] : sampling.verticesByRays)
    if (rays <= sampling.verticesByRays.back().first / 8) few += vertices;
  EXPECT_GT(few, field * 3 / 4);
  EXPECT_LE(sampling.errorBound, 0.002);
}

TEST(ControlledBake, SameBitsForAnyNumberOfThreads) {
  const Scene scene = boxesInRow();
  BakeRequest asked{.model = "interreflected", .degree = 3};
  asked.samplingError = 0.03;
  setThreadCount(1);
  const Bake one = bakeRequested(PreparedScene(scene), asked);
  setThreadCount(0);
  const Bake many = bakeRequested(PreparedScene(scene), asked);
  EXPECT_EQ(one.transfer.values, many.transfer.values);
  EXPECT_EQ(one.error.values, many.error.values);
  EXPECT_EQ(one.statistics.sampling.errorBound, many.statistics.sampling.errorBound);
}

TEST(ControlledBake, MeasuringChangesNothing) {
  const Scene scene = boxesInRow();
  for (const char* model : {"shadowed", "interreflected"}) {
    BakeRequest asked{.model = model, .degree = 3, .rays = 100};
    const Bake plain = bakeRequested(PreparedScene(scene), asked);
    EXPECT_FALSE(plain.statistics.sampling.measured);
    EXPECT_TRUE(plain.error.empty());
    asked.measureError = true;
    const Bake measured = bakeRequested(PreparedScene(scene), asked);
    EXPECT_EQ(plain.transfer.values, measured.transfer.values) << model;
    EXPECT_TRUE(measured.statistics.sampling.measured);
    EXPECT_GT(measured.statistics.sampling.error, 0);
  }
}

TEST(ControlledBake, WithoutTimeItIsTheFirstPass) {
  const Scene scene = boxesInRow();
  BakeRequest asked{.model = "shadowed", .degree = 3};
  asked.seconds = 1e-9;
  asked.samplingError = 1e-4;
  const SamplingStatistics sampling = bakeRequested(PreparedScene(scene), asked).statistics.sampling;
  EXPECT_EQ(sampling.passes.size(), 1u);
  EXPECT_GT(sampling.errorBound, 1e-4);
  // With time enough the error decides.
  asked.seconds = 1e6;
  asked.samplingError = 0.05;
  EXPECT_LE(bakeRequested(PreparedScene(scene), asked).statistics.sampling.errorBound, 0.05);
}

// What is buried is a fact of the scene.
TEST(ControlledBake, BurialsAreTheSameForAnyRaysAndSeeds) {
  const Scene scene = loadScene(SHPRT_SOURCE_DIR "/data/courtyard.obj", {});
  const PreparedScene prepared(scene);
  std::vector<std::uint64_t> counts;
  for (const char* model : {"shadowed", "interreflected"})
    for (const int rays : {32, 128, 1024})
      for (const std::uint64_t seed : {1u, 2u}) {
        const BakeRequest asked{.model = model, .degree = 0, .rays = rays, .seed = seed, .bounces = 1};
        counts.push_back(bakeRequested(prepared, asked).statistics.buriedVertices);
      }
  for (const std::uint64_t count : counts) EXPECT_EQ(count, counts.back());
  EXPECT_GT(counts.back(), 0u);
}

}  // namespace
}  // namespace shprt
