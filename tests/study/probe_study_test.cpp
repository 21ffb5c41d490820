#include "shprt/study/probe_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "curve_run.h"
#include "shprt/study/shrink_probe.h"

namespace shprt {
namespace {

struct Picture {
  EnvironmentLayout layout;
  int width, height;
};
constexpr Picture kPictures[] = {{EnvironmentLayout::kLatitudeLongitude, 48, 24},
                                 {EnvironmentLayout::kVerticalCross, 36, 48},
                                 {EnvironmentLayout::kHorizontalCross, 48, 36},
                                 {EnvironmentLayout::kCubeStrip, 12, 72},
                                 {EnvironmentLayout::kOpenExrCube, 12, 72}};

double power(const EnvironmentMap& map) {
  double sum = 0;
  for (int y = 0; y < map.image.height; ++y)
    for (int x = 0; x < map.image.width; ++x)
      sum += pixelFootprint(map.layout, map.image.width, map.image.height, x, y).solidAngle *
             static_cast<double>(map.image.at(x, y).x);
  return sum;
}

TEST(ShrinkProbe, KeepsAConstant) {
  for (const auto& [layout, width, height] : kPictures) {
    EnvironmentMap map = test::slopedMap(layout, width, height);
    for (Vec3f& pixel : map.image.pixels) pixel = {0.3f, 1.7f, 5.1f};
    for (const int factor : {1, 2, 5, 12, 100}) {
      const EnvironmentMap small = shrinkProbe(map, factor);
      for (int y = 0; y < small.image.height; ++y)
        for (int x = 0; x < small.image.width; ++x) {
          if (pixelFootprint(layout, small.image.width, small.image.height, x, y).solidAngle <= 0) continue;
          EXPECT_FLOAT_EQ(small.image.at(x, y).x, 0.3f);
          EXPECT_FLOAT_EQ(small.image.at(x, y).y, 1.7f);
          EXPECT_FLOAT_EQ(small.image.at(x, y).z, 5.1f);
        }
    }
  }
}

TEST(ShrinkProbe, KeepsThePower) {
  for (const auto& [layout, width, height] : kPictures) {
    const EnvironmentMap map = test::slopedMap(layout, width, height);
    for (const int factor : {2, 3, 4, 6, 12}) {
      const EnvironmentMap small = shrinkProbe(map, factor);
      EXPECT_EQ(small.image.width, width / factor);
      EXPECT_EQ(small.image.height, height / factor);
      EXPECT_NEAR(power(small) / power(map), 1, 1e-6) << layoutName(layout) << " " << factor;
    }
  }
}

TEST(ShrinkProbe, SidesThatDoNotDivideAreCoveredByShares) {
  EnvironmentMap map = test::slopedMap(EnvironmentLayout::kLatitudeLongitude, 5, 1);
  for (int x = 0; x < 5; ++x) map.image.at(x, 0) = {float(x), 0, 0};
  const EnvironmentMap small = shrinkProbe(map, 2);
  ASSERT_EQ(small.image.width, 2);
  EXPECT_FLOAT_EQ(small.image.at(0, 0).x, (0 + 1 + 0.5f * 2) / 2.5f);
  EXPECT_FLOAT_EQ(small.image.at(1, 0).x, (0.5f * 2 + 3 + 4) / 2.5f);
}

TEST(ShrinkProbe, LeavesOutWhatIsNotFinite) {
  EnvironmentMap map = test::slopedMap(EnvironmentLayout::kLatitudeLongitude, 8, 4);
  for (Vec3f& pixel : map.image.pixels) pixel = {2, 2, 2};
  const float infinity = std::numeric_limits<float>::infinity();
  map.image.at(0, 0) = {infinity, 0, 0};
  for (const int x : {6, 7})
    for (const int y : {2, 3}) map.image.at(x, y) = {0, infinity, 0};
  const EnvironmentMap small = shrinkProbe(map, 2);
  EXPECT_FLOAT_EQ(small.image.at(0, 0).x, 2);
  EXPECT_TRUE(std::isnan(small.image.at(3, 1).x));
}

// Averaging leaves a constant alone; what is left is that projection takes the basis at the middle of pixels,
// the midpoint rule with its error of h^2/24 times second derivatives, which are l^2 at most.
TEST(ProbeStudy, ConstantLightLosesNothingButTheMidpointRules) {
  EnvironmentMap map = test::slopedMap(EnvironmentLayout::kLatitudeLongitude, 128, 64);
  for (Vec3f& pixel : map.image.pixels) pixel = {0.5f, 1, 2};
  test::CurveRun test(test::ballOverFloor());
  test.lightBy(map);
  const StudySection section = probeStudy(test.run).measure(test.run);
  for (const int factor : {2, 4, 8})
    for (const int degree : {4, 8}) {
      const double bound = std::pow(degree * std::numbers::pi * factor / 64, 2) / 24;
      for (const std::string what : {".coefficients", ".radiance"})
        EXPECT_LE(test::figure(section,
                               "probe." + std::to_string(factor) + what + ".degree" + std::to_string(degree)),
                  bound);
    }
}

TEST(ProbeStudy, SaysWhyItIsMissingWithoutAnImage) {
  test::CurveRun test(test::ballOverFloor());
  EXPECT_EQ(probeStudy(test.run).steps, 0);
  EXPECT_NE(probeStudy(test.run).measure(test.run).missing.find("no light"), std::string::npos);
  test.lightBy(projectConstant({1, 1, 1}, 4));
  EXPECT_NE(probeStudy(test.run).measure(test.run).missing.find("no image"), std::string::npos);
  EXPECT_TRUE(test.announced.empty());
}

}  // namespace
}  // namespace shprt
