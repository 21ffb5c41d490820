#include "shprt/study/sampling_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "curve_run.h"
#include "shprt/sh/basis.h"
#include "shprt/study/adaptive_study.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {
namespace {

// Where everything is seen, the mean of N independent cosine-distributed values of all y is off by
// (sum of E y^2 - |U|^2) / N in the square, and the sum of all y^2 to degree L is (L+1)^2 / 4 pi.
TEST(SamplingStudy, UnoccludedObjectIsExactButForPlainRandomDirections) {
  test::CurveRun test(test::grey(test::makeIcosphere(2), 0.7f), "unshadowed");
  const StudySection section = samplingStudy(test.run).measure(test.run);
  const double norm = unshadowedNorm(test.run.options.degree);
  for (const int rays : {16, 64, 256}) {
    for (const std::string set : {"random-cv", "jittered-cv", "sobol", "lattice"})
      EXPECT_EQ(test::figure(section, "rays." + set + "." + std::to_string(rays) + ".error"), 0);
    const double expected =
        std::sqrt((coefficientCount(test.run.options.degree) / (4 * std::numbers::pi) - norm * norm) / rays) /
        norm;
    EXPECT_NEAR(test::figure(section, "rays.random." + std::to_string(rays) + ".error") / expected, 1, 0.1);
  }
  EXPECT_NE(section.text.find("no error at all"), std::string::npos);
  // What has no error cannot be shown along logarithmic axes.
  EXPECT_EQ(section.charts.front().curves.size(), 2u);
}

TEST(SamplingStudy, RandomErrorsFallAsTheRootOfRays) {
  test::CurveRun test(test::ballOverFloor(15));
  const StudySection section = samplingStudy(test.run).measure(test.run);
  EXPECT_NEAR(test::figure(section, "slope.random"), -0.5, 0.06);
  EXPECT_NEAR(test::figure(section, "slope.random-cv"), -0.5, 0.1);
  EXPECT_LT(test::figure(section, "slope.lattice"), -0.6);
  EXPECT_GT(test::figure(section, "rays.random.ratio256"), 10);
  EXPECT_GT(test::figure(section, "rays.jittered.ratio256"), 1);
  EXPECT_GT(test::figure(section, "rays.jittered-cv.ratio256"), 1);
  ASSERT_EQ(section.charts.size(), 2u);
  for (const StudyChart& chart : section.charts) {
    EXPECT_EQ(chart.curves.size(), 6u);
    for (const StudyCurve& curve : chart.curves) EXPECT_EQ(curve.points.size(), 3u);
  }
}

TEST(AdaptiveStudy, ComparesWithTheLattice) {
  test::CurveRun test(test::ballOverFloor());
  const StudySection section = adaptiveStudy(test.run).measure(test.run);
  ASSERT_EQ(section.tables.size(), 1u);
  EXPECT_EQ(section.tables.front().rows.size(), 3u);
  for (const std::string asked : {"0.1", "0.03", "0.01"}) {
    EXPECT_GT(test::figure(section, "adaptive." + asked + ".rays"), 0);
    EXPECT_NEAR(test::figure(section, "adaptive." + asked + ".ratio"),
                test::figure(section, "adaptive." + asked + ".error") / std::stod(asked), 1e-12);
  }
}

}  // namespace
}  // namespace shprt
