// Rays go where theory sends them.
#include <gtest/gtest.h>

#include <cmath>

#include "shprt/transfer/merge_pass.h"
#include "shprt/transfer/ray_allocation.h"
#include "shprt/transfer/ray_plan.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

constexpr std::uint32_t kRays = 64;

// Two patches apart; points of the second have a hundredth of the variance. Variance falls as 1/rays.
class TwoPatches : public testing::Test {
 protected:
  TwoPatches() {
    for (const double x : {0.0, 5.0}) test::addPatch(mesh_, {x, 0, 0}, {0, 0, 1}, {1, 0, 0}, 9);
    topology_.emplace(mesh_);
    errors_ = PointErrors(topology_->pointCount(), {.channels = 1, .degree = 0});
    weights_.assign(topology_->pointCount(), Vec3d{1, 1, 1});
    for (std::size_t point = 0; point < errors_.rays.size(); ++point) {
      const float variance = isFirst(point) ? 1.0f : 0.01f;
      errors_.squares.row(point)[0] = variance;
      errors_.rays[point] = kRays;
      errors_.quarters[point] = variance, errors_.sixteenths[point] = 4 * variance;
    }
  }
  bool isFirst(std::size_t point) const {
    return mesh_.positions[topology_->verticesOfPoint(point).front()].x < 3;
  }

  Mesh mesh_;
  std::optional<SurfaceTopology> topology_;
  PointErrors errors_;
  std::vector<Vec3d> weights_;
};

TEST_F(TwoPatches, TakeRaysByTheRootOfTheirVariance) {
  const RayAllocator allocator(errors_, *topology_, weights_, 1, 1.5);
  const RayAllocation allocation = allocator.forError(0.1);
  double first = 0, second = 0;
  for (std::size_t point = 0; point < errors_.rays.size(); ++point)
    (isFirst(point) ? first : second) = allocation.levels[point];
  // A hundredth of the mean is added to each.
  const double unseen = 0.01 * (1 + 0.01) / 2;
  EXPECT_NEAR(first - second, 0.5 * std::log2((1 + unseen) / (0.01 + unseen)),
              1);  // two levels, each rounded
  EXPECT_LE(allocation.error, 0.1);
  // One level less would miss it: with p = 1 twice the squared error.
  EXPECT_GT(allocation.error, 0.1 / std::sqrt(2.0) / 1.01);
}

TEST_F(TwoPatches, NeverTakeMoreThanThereIs) {
  const RayAllocator allocator(errors_, *topology_, weights_, 1, 1.5);
  const double least = RayPlan::kLeastRays * static_cast<double>(errors_.rays.size());
  double before = 0;
  for (const double rays : {least, 3 * least, 10 * least, 100 * least}) {
    const RayAllocation allocation = allocator.forRays(rays);
    EXPECT_LE(allocation.rays, rays);
    EXPECT_GE(allocation.rays, before);
    before = allocation.rays;
  }
  EXPECT_GT(before, 40 * least);
  EXPECT_EQ(allocator.forRays(0).rays, least);
  EXPECT_EQ(allocator.forError(1e-12).levels[0], RayPlan::kLevels - 1);
}

TEST_F(TwoPatches, ExactAndBlackPointsTakeTheLeast) {
  for (std::size_t point = 0; point < errors_.rays.size(); ++point) {
    if (isFirst(point)) continue;
    if (point % 2 == 0) errors_.rays[point] = 0;
    if (point % 2 == 1) weights_[point] = {};
  }
  const RayAllocation allocation = RayAllocator(errors_, *topology_, weights_, 1, 1.5).forError(0.05);
  for (std::size_t point = 0; point < errors_.rays.size(); ++point) {
    if (isFirst(point)) {
      EXPECT_GT(allocation.levels[point], 0) << point;
    } else {
      EXPECT_EQ(allocation.levels[point], 0) << point;
    }
  }
}

TEST(MergePass, WeighsByCertaintyAndAddsVariances) {
  Bake before, bake;
  before.transfer = {.degree = 0, .channels = 1, .vertexCount = 1, .values = {3}};
  bake.transfer = {.degree = 0, .channels = 1, .vertexCount = 1, .values = {1}};
  PointErrors errorsBefore(1, {.channels = 1, .degree = 0}), errors = errorsBefore;
  errorsBefore.squares.row(0)[0] = 4, errors.squares.row(0)[0] = 1;
  errorsBefore.rays[0] = 32, errors.rays[0] = 128;
  mergePass(before, errorsBefore, 2, bake, errors, 1);
  // Weights 4/5 and 1/5: the mean of least variance, 1 / (1 + 1/4).
  EXPECT_FLOAT_EQ(bake.transfer.values[0], 1.4f);
  EXPECT_FLOAT_EQ(errors.squares.row(0)[0], 0.8f);
  EXPECT_EQ(errors.rays[0], 160u);
}

}  // namespace
}  // namespace shprt
