#include "shprt/study/sampling_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace shprt {
namespace {

TEST(RaysForError, FollowPowerLaws) {
  std::vector<std::pair<double, double>> points;
  for (const double rays : {16.0, 64.0, 256.0}) points.emplace_back(rays, 3 * std::pow(rays, -0.7));
  for (const double rays : {2.0, 20.0, 64.0, 200.0, 5000.0}) {
    const auto found = raysForError(points, 3 * std::pow(rays, -0.7));
    ASSERT_TRUE(found) << rays;
    EXPECT_NEAR(*found / rays, 1, 1e-9);
  }
}

TEST(RaysForError, KnowNothingWithoutAFallingCurve) {
  EXPECT_FALSE(raysForError({{16, 0}, {64, 0}}, 0.1));
  EXPECT_FALSE(raysForError({{16, 0.1}, {64, 0.2}}, 0.1));
  EXPECT_FALSE(raysForError({{16, 0.2}, {64, 0.1}}, 0));
  EXPECT_FALSE(raysForError({}, 0.1));
}

}  // namespace
}  // namespace shprt
