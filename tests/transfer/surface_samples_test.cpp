// Samples over triangles: how many, how even, and whose.
#include "shprt/transfer/surface_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

std::map<std::uint32_t, int> countPerTriangle(std::span<const SurfaceSample> samples) {
  std::map<std::uint32_t, int> counts;
  for (const SurfaceSample& sample : samples) ++counts[sample.triangle];
  return counts;
}

TEST(SurfaceSamples, CountsFollowAreaAndNoTriangleIsLeftOut) {
  // Two squares of one quad each, 10 and 1/1024 wide, which floats hold exactly.
  Mesh mesh;
  test::addPatch(mesh, {0, 0, 0}, {0, 0, 10}, {10, 0, 0});
  test::addPatch(mesh, {20, 0, 0}, {0, 0, 1.0 / 1024}, {1.0 / 1024, 0, 0});
  const Scene scene = test::grey(mesh, 1);
  const SurfaceTopology topology(scene.mesh);
  const auto samples = sampleSurface(scene, topology, {.perTriangle = 50, .minimum = 3, .seed = 1});
  EXPECT_EQ(countPerTriangle(samples), (std::map<std::uint32_t, int>{{0, 100}, {1, 100}, {2, 3}, {3, 3}}));
  double area = 0, small = 0;
  for (const SurfaceSample& sample : samples) {
    area += sample.weight;
    if (sample.triangle >= 2) small += sample.weight;
    EXPECT_GE(sample.u, 0);
    EXPECT_GE(sample.v, 0);
    EXPECT_LE(sample.u + sample.v, 1 + 1e-6f);
  }
  // The scene frame is scaled by 1/16 (extent 20 becomes 1.25).
  EXPECT_NEAR(area * 256, 100 + 0x1p-20, 1e-9);
  EXPECT_NEAR(small * 256, 0x1p-20, 1e-15);
}

TEST(SurfaceSamples, EveryPartOfATriangleHoldsOne) {
  Mesh mesh;
  test::addPatch(mesh, {0, 0, 0}, {0, 0, 1}, {1, 0, 0});
  const Scene scene = test::grey(mesh, 1);
  const SurfaceTopology topology(scene.mesh);
  for (const std::uint64_t seed : {1u, 2u, 3u})
    for (const int parts : {4, 8, 16}) {
      const int count = parts * parts;
      const auto samples = sampleSurface(scene, topology, {.perTriangle = 1, .minimum = count, .seed = seed});
      std::set<std::tuple<std::uint32_t, int, int, bool>> occupied;
      for (const SurfaceSample& sample : samples) {
        const float u = sample.u * static_cast<float>(parts), v = sample.v * static_cast<float>(parts);
        occupied.emplace(sample.triangle, static_cast<int>(u), static_cast<int>(v),
                         u - std::floor(u) + v - std::floor(v) > 1);
      }
      EXPECT_EQ(occupied.size(), static_cast<std::size_t>(2 * count)) << parts << " parts along an edge";
    }
}

TEST(SurfaceSamples, IntegrateWhatVariesSlowly) {
  // Stratification into n parts of size 1/sqrt(n) leaves a standard deviation of the mean of u below
  // 1/sqrt(n) * 1/sqrt(n) * sqrt(1/18); independent points would have sqrt(1/18)/sqrt(n).
  Mesh mesh;
  test::addPatch(mesh, {0, 0, 0}, {0, 0, 1}, {1, 0, 0});
  const Scene scene = test::grey(mesh, 1);
  const SurfaceTopology topology(scene.mesh);
  const int count = 256;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    double u = 0, v = 0;
    for (const SurfaceSample& sample :
         sampleSurface(scene, topology, {.perTriangle = 1, .minimum = count, .seed = seed}))
      u += static_cast<double>(sample.u), v += static_cast<double>(sample.v);
    const double bound = 5 * std::sqrt(1.0 / 18) / count;
    EXPECT_NEAR(u / (2 * count), 1.0 / 3, bound);
    EXPECT_NEAR(v / (2 * count), 1.0 / 3, bound);
  }
}

TEST(SurfaceSamples, BlockersHaveNoneAndASeedFixesAll) {
  Mesh mesh;
  test::addPatch(mesh, {0, 0, 0}, {0, 0, 1}, {1, 0, 0});
  const auto receivers = static_cast<std::uint32_t>(mesh.positions.size());
  test::addPatch(mesh, {0, 1, 0}, {0, 0, 1}, {1, 0, 0});
  Scene scene = test::grey(mesh, 1);
  scene.objects.push_back({.name = "lid", .file = "", .role = Role::kBlocker, .report = {}});
  for (std::uint32_t v = receivers; v < mesh.positions.size(); ++v) scene.vertexObjects[v] = 1;
  const SurfaceTopology topology(scene.mesh);
  const auto draw = [&](std::uint64_t seed) {
    std::vector<float> numbers;
    for (const SurfaceSample& sample : sampleSurface(scene, topology, {.seed = seed})) {
      EXPECT_LT(sample.triangle, 2u);
      numbers.insert(numbers.end(), {sample.u, sample.v});
    }
    return numbers;
  };
  EXPECT_EQ(draw(7), draw(7));
  EXPECT_NE(draw(7), draw(8));
}

}  // namespace
}  // namespace shprt
