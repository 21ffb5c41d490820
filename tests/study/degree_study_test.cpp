#include "shprt/study/degree_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "curve_run.h"
#include "shprt/relight/relight.h"
#include "shprt/sh/zonal.h"
#include "shprt/study/reference.h"

namespace shprt {
namespace {

// Unshadowed transfer has A_l^2 (2l+1) / 4 pi in band l.
TEST(DegreeStudy, UnoccludedTransferLeavesOutWhatTheClampedCosineHolds) {
  test::CurveRun test(test::grey(test::makeIcosphere(1), 0.3f));
  const StudySection section = degreeStudy(test.run).measure(test.run);
  const int top = 16;
  const std::vector<double> factors = clampedCosineFactors(top);
  double whole = 0;
  for (int l = 0; l <= top; ++l) whole += factors[l] * factors[l] * (2 * l + 1);
  double held = 0;
  for (int l = 0; l < top; ++l) {
    held += factors[l] * factors[l] * (2 * l + 1);
    EXPECT_NEAR(test::figure(section, "degree." + std::to_string(l) + ".transfer"),
                std::sqrt((whole - held) / whole), 1e-5);
  }
  EXPECT_EQ(section.charts.front().curves.size(), 1u);
  EXPECT_NE(section.text.find("depends on the light"), std::string::npos);
}

TEST(DegreeStudy, RadianceIsWhatRelightingWithLessOfTheLightLosesOfIt) {
  const Scene scene = test::grey(test::makeIcosphere(1), 0.3f);
  const LightCoefficients sun = projectDirectional({1, 2, 3}, {1, 0.5, 0.2}, 16);
  test::CurveRun test(scene);
  test.lightBy(sun);
  const StudySection section = degreeStudy(test.run).measure(test.run);
  const TransferCoefficients transfer = bakeUnshadowed(scene, 16).transfer;
  const std::vector<Vec3f> reference = relight(transfer, sun);
  for (int l = 0; l < 16; ++l) {
    const double expected = radianceError(relight(transfer, withDegree(sun, l)), reference);
    EXPECT_NEAR(test::figure(section, "degree." + std::to_string(l) + ".radiance"), expected, 1e-5);
  }
  // A directional light has (2l+1) / 4 pi in each band.
  EXPECT_NEAR(test::figure(section, "degree.4.light"), std::sqrt(1 - 25.0 / (17 * 17)), 1e-9);
  // An icosphere is nearly as good as all directions.
  EXPECT_NEAR(test::figure(section, "degree.1.radiance") / test::figure(section, "degree.1.turned"), 1, 0.05);
}

TEST(DegreeStudy, ConstantLightNeedsNoBands) {
  test::CurveRun test(test::ballOverFloor());
  test.lightBy(projectConstant({1, 1, 1}, 4));
  const StudySection section = degreeStudy(test.run).measure(test.run);
  EXPECT_EQ(test::figure(section, "degree.0.radiance"), 0);
  EXPECT_EQ(test::figure(section, "degree.0.light"), 0);
  EXPECT_GT(test::figure(section, "degree.4.transfer"), 0.05);
  EXPECT_EQ(test::figure(section, "degree.least.0.01"), 0);
}

}  // namespace
}  // namespace shprt
