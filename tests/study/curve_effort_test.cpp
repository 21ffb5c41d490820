#include "shprt/study/curve_effort.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../transfer/test_meshes.h"

namespace shprt {
namespace {

TEST(TracedPoints, CountsWhatReceiversShare) {
  Mesh mesh = test::makeIcosphere(0);
  test::append(mesh, test::makeIcosphere(0));
  const Scene scene = test::grey(mesh, 1);
  EXPECT_EQ(tracedPoints(PreparedScene(scene)), 12u);
}

TEST(CurveEffort, HoldsTheRaysThatMethodsAreComparedBy) {
  for (const bool quick : {false, true}) {
    const CurveEffort effort = curveEffort({.quick = quick});
    EXPECT_EQ(std::count(effort.rays.begin(), effort.rays.end(), 256), 1);
    EXPECT_TRUE(std::is_sorted(effort.rays.begin(), effort.rays.end()));
    EXPECT_TRUE(std::is_sorted(effort.errors.rbegin(), effort.errors.rend()));
    EXPECT_GE(effort.referenceRays, 16 * effort.rays.back());
  }
}

TEST(BestSeconds, RepeatsWhatIsShort) {
  int runs = 0;
  EXPECT_EQ(bestSeconds([&] { return 0.02 * (5 - ++runs); }), 0.04);
  EXPECT_EQ(runs, 3);
  runs = 0;
  EXPECT_EQ(bestSeconds([&] { return ++runs, 10.0; }), 10);
  EXPECT_EQ(runs, 1);
}

}  // namespace
}  // namespace shprt
