// What is left of a series whose terms are known.
#include <gtest/gtest.h>

#include <cmath>

#include "shprt/transfer/bounce_series.h"

namespace shprt {
namespace {

TEST(BounceSeries, OfOneRatioLeavesTheTailOfAGeometricSeries) {
  BounceSeries series(1, {0.5});
  for (const double norm : {0.8, 0.4, 0.2, 0.1}) series.add({{norm, norm}});
  EXPECT_EQ(series.bounces(), 3);
  EXPECT_DOUBLE_EQ(series.norm(), 0.1);
  EXPECT_DOUBLE_EQ(series.ratio(0), 0.5);
  EXPECT_NEAR(series.remainder(), 0.05 + 0.025 + 0.0125 + 0.00625 + 0.00625, 1e-12);
}

// Light in an open part that fades at once beside light in a cavity that lingers: while the first still
// dominates the norms, ratios are far below the cavity's. Where a few percent are said to be left, no more
// are.
TEST(BounceSeries, BoundsTheRestWhileRatiosStillRise) {
  int judged = 0;
  const double open = 0.15, cavity = 0.6, share = 0.2;
  BounceSeries series(1, {0.8});
  for (int k = 0; k <= 8; ++k) {
    const double norm = std::hypot(std::pow(open, k), share * std::pow(cavity, k));
    series.add({{norm, norm}});
    double rest = 0;
    for (int j = k + 1; j < 200; ++j) rest += std::hypot(std::pow(open, j), share * std::pow(cavity, j));
    if (k >= 2 && series.remainder() <= 0.05) {
      EXPECT_GE(series.remainder(), rest) << k;
      ++judged;
    }
    EXPECT_LE(series.ratio(0), 0.8);
  }
  EXPECT_GE(judged, 3);
}

TEST(BounceSeries, WithoutBouncesOnlyTheBoundIsKnown) {
  BounceSeries series(1, {0.75});
  series.add({{0.5, 0.5}});
  EXPECT_DOUBLE_EQ(series.remainder(), 1.5);
  EXPECT_EQ(series.largestRatio(), 0);
}

TEST(BounceSeries, WhatReflectsNothingLeavesNothing) {
  BounceSeries series(1, {0});
  series.add({{0.5, 0.5}});
  EXPECT_EQ(series.remainder(), 0);
}

TEST(BounceSeries, ChannelsCountByTheirRms) {
  BounceSeries series(3, {0.5, 0.5, 0.5});
  series.add({{1, 1}, {1, 1}, {0, 0}});
  series.add({{0.5, 0.5}, {0.25, 0.25}, {0, 0}});
  EXPECT_NEAR(series.norm(), std::sqrt((0.25 + 0.0625) / 3), 1e-12);
  EXPECT_EQ(series.ratio(2), 0);
}

// Light that is still on blockers only may reach receivers with the next bounce.
TEST(BounceSeries, LightOnBlockersIsNotForgotten) {
  BounceSeries series(1, {0.9});
  series.add({{0, 0.5}});
  series.add({{0, 0.4}});
  EXPECT_GT(series.remainder(), 0.4);
  series.add({{0, 0}});
  EXPECT_EQ(series.remainder(), 0);
}

// The scene's own lights are judged by what they have brought: here 1 + 1/2, and 1/2 is to come.
TEST(BounceSeries, OwnLightsAreMeasuredAgainstThemselves) {
  BounceSeries series(1, {0.5, 0.5});
  series.add({{0, 0}, {1, 1}});
  series.add({{0, 0}, {0.5, 0.5}});
  EXPECT_NEAR(series.remainder(), 0.5 / 1.5, 1e-12);
}

}  // namespace
}  // namespace shprt
