// Windows, and the irradiance they are there for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shprt/base/error.h"
#include "shprt/light/irradiance_minimum.h"
#include "shprt/light/project_probe.h"
#include "shprt/light/window.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"
#include "shprt/sh/zonal.h"

namespace shprt {
namespace {

using std::numbers::pi;

TEST(Windows, HaveTheirFormulas) {
  LightCoefficients light;
  light.degree = 3;
  light.coefficients.assign(16, {1, 1, 1});
  const LightCoefficients hann = applyWindow(light, Window::kHann).light,
                          lanczos = applyWindow(light, Window::kLanczos).light;
  EXPECT_NEAR(hann.coefficients[0][0], 1, 1e-15);
  EXPECT_NEAR(hann.coefficients[4][0], 0.5, 1e-15);
  EXPECT_NEAR(hann.coefficients[9][0], (1 + std::cos(0.75 * pi)) / 2, 1e-15);
  EXPECT_NEAR(lanczos.coefficients[4][0], std::sin(0.5 * pi) / (0.5 * pi), 1e-15);
  EXPECT_EQ(applyWindow(light, Window::kNone).light.coefficients, light.coefficients);
  EXPECT_THROW(parseWindow("blackman"), Error);
}

// The irradiance of a sun is zonal, sum over l of (2l+1) A_l / pi P_l relative to its average: a function of
// one variable whose least value a fine scan finds. Degree 2 in closed form: 1 + 2x + 5/4 (3x^2 - 1)/2 is
// least at x = -8/15.
double leastIrradianceOfASun(int degree) {
  const std::vector<double> cosine = clampedCosineFactors(degree);
  double least = 1, lowest = 0;
  const auto scan = [&](double from, double to) {
    for (int i = 0; i <= 2000; ++i) {
      const double x = std::clamp(from + (to - from) * i / 2000, -1.0, 1.0);
      double sum = 0;
      for (int l = 0; l <= degree; ++l)
        sum += (2 * l + 1) * cosine[static_cast<std::size_t>(l)] / pi *
               std::legendre(static_cast<unsigned>(l), x);
      if (sum < least) least = sum, lowest = x;
    }
  };
  scan(-1, 1);
  scan(lowest - 1e-3, lowest + 1e-3);
  return least;
}

TEST(LeastIrradiance, OfASunIsThatOfTheTruncatedCosine) {
  EXPECT_NEAR(leastIrradianceOfASun(2), 1 - 16.0 / 15 + 1.25 * (3 * 64.0 / 225 - 1) / 2, 1e-9);
  for (const int degree : {0, 1, 2, 4, 7, 12})
    for (const Vec3d towards : {Vec3d{1, 2, 3}, Vec3d{0, 0, 1}, Vec3d{0, 1, 0}})
      EXPECT_NEAR(leastRelativeIrradiance(projectDirectional(towards, {1, 0, 3}, degree)),
                  leastIrradianceOfASun(degree), 1e-8)
          << degree;
}

// Two dips whose grid values may deceive: the deeper one is found wherever it is turned.
TEST(LeastIrradiance, DoesNotDependOnTheGrid) {
  const LightCoefficients pair = addLights(projectDirectional({1, 0, 0}, {1, 1, 1}, 6),
                                           projectDirectional({-0.2, 0.9, 0.3}, {0.97, 0.97, 0.97}, 6));
  const double least = leastRelativeIrradiance(pair);
  for (const char* turn : {"axis:0,0,1,3", "axis:1,2,3,50", "euler:zyz,10,20,30", "axis:1,0,0,90"})
    EXPECT_NEAR(leastRelativeIrradiance(rotateLight(pair, parseRotation(turn))), least, 1e-9) << turn;
}

TEST(LeastIrradiance, LeavesOutColoursWithoutAnAverage) {
  EXPECT_EQ(leastRelativeIrradiance(projectConstant({0, 0, 0}, 3)), 1);
  EXPECT_NEAR(leastRelativeIrradiance(projectConstant({0, 2, 0}, 3)), 1, 1e-14);
}

TEST(Windows, AutoIsTheLeastThatKeepsIrradiancePositive) {
  for (const int degree : {2, 4, 8}) {
    const LightCoefficients sun = projectDirectional({1, 2, 3}, {2, 1, 0.5}, degree);
    const WindowResult result = applyWindow(sun, Window::kAuto);
    EXPECT_EQ(result.name, "auto");
    EXPECT_EQ(result.light.coefficients[0], sun.coefficients[0]);
    // Not below zero, and no higher than it must be.
    EXPECT_GE(result.minimumIrradiance, 0);
    EXPECT_LT(result.minimumIrradiance, 1e-8);
    const double factor = 1 / (1 - leastIrradianceOfASun(degree));
    EXPECT_NEAR(result.strength, 1 - factor * factor, 1e-7);
  }
}

TEST(Windows, AutoLeavesAloneWhatIsPositive) {
  const LightCoefficients overcast =
      addLights(projectDirectional({1, 2, 3}, {0.1, 0.1, 0.1}, 4), projectConstant({1, 1, 1}, 4));
  const WindowResult result = applyWindow(overcast, Window::kAuto);
  EXPECT_EQ(result.light.coefficients, overcast.coefficients);
  EXPECT_EQ(result.strength, 0);
  EXPECT_GT(result.minimumIrradiance, 0.9);
}

}  // namespace
}  // namespace shprt
