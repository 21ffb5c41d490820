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
  const LightCoefficients gaussian = applyWindow(light, Window::kGaussian).light;
  EXPECT_NEAR(gaussian.coefficients[0][0], 1, 1e-15);
  EXPECT_NEAR(gaussian.coefficients[4][0], std::exp(-pi * pi / 64 * 6), 1e-15);
  EXPECT_NEAR(gaussian.coefficients[15][0], std::exp(-pi * pi / 64 * 12), 1e-15);
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
    EXPECT_GE(result.minimumIrradiance.value(), 0);
    EXPECT_LT(result.minimumIrradiance.value(), 1e-8);
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
  EXPECT_GT(result.minimumIrradiance.value(), 0.9);
}

// A sun of average 1 is cut off to the sum over l of (2l+1) P_l(x): at degree 1, 1 + 3x is least at -1; at
// degree 2, 1 + 3x + 5 (3x^2 - 1)/2 at -1/5, where it is -1.8; at degree 3 the end x = -1,
// 1 - 3 + 5 - 7, lies below the dip inside, -2.6.
TEST(LeastRadiance, OfASunInClosedForm) {
  const auto leastOf = [](int degree) {
    double least = 1;
    for (const Vec3d towards : {Vec3d{1, 2, 3}, Vec3d{0, 0, 1}, Vec3d{0, 1, 0}})
      least = std::min(least, leastRelativeRadiance(projectDirectional(towards, {1, 0, 3}, degree)));
    return least;
  };
  EXPECT_NEAR(leastOf(0), 1, 1e-15);
  EXPECT_NEAR(leastOf(1), -2, 1e-8);
  EXPECT_NEAR(leastOf(2), -1.8, 1e-8);
  EXPECT_NEAR(leastOf(3), -4, 1e-8);
}

TEST(LeastRadiance, IsNeverAboveTheLeastIrradiance) {
  LightCoefficients light;
  light.degree = 5;
  for (int seed = 0; seed < 8; ++seed) {
    light.coefficients.clear();
    for (int i = 0; i < 36; ++i)
      light.coefficients.push_back(
          {i == 0 ? 6 : std::cos(seed + i * i), i == 0 ? 9 : std::sin(seed * i + 1), 0});
    EXPECT_LE(leastRelativeRadiance(light), leastRelativeIrradiance(light) + 1e-9) << seed;
  }
}

TEST(Windows, AutoRadianceIsTheLeastThatKeepsRadiancePositive) {
  const double least[] = {1, -2, -1.8};
  for (const int degree : {1, 2}) {
    const LightCoefficients sun = projectDirectional({1, 2, 3}, {2, 1, 0.5}, degree);
    const WindowResult result = applyWindow(sun, Window::kAutoRadiance);
    EXPECT_EQ(result.name, "auto-radiance");
    EXPECT_EQ(result.light.coefficients[0], sun.coefficients[0]);
    EXPECT_GE(result.minimumRadiance.value(), 0);
    EXPECT_LT(result.minimumRadiance.value(), 1e-8);
    EXPECT_GE(result.minimumIrradiance.value(), 0);
    const double factor = 1 / (1 - least[degree]);
    EXPECT_NEAR(result.strength, 1 - factor * factor, 1e-7);
  }
  const LightCoefficients overcast =
      addLights(projectDirectional({1, 2, 3}, {0.1, 0.1, 0.1}, 4), projectConstant({1, 1, 1}, 4));
  EXPECT_EQ(applyWindow(overcast, Window::kAutoRadiance).light.coefficients, overcast.coefficients);
}

TEST(Windows, SearchForLeastValuesStopsAtItsDegree) {
  const LightCoefficients sun = projectDirectional({1, 2, 3}, {2, 1, 0.5}, kMaximumSearchDegree + 1);
  const WindowResult result = applyWindow(sun, Window::kHann);
  EXPECT_FALSE(result.minimumIrradiance.has_value());
  EXPECT_FALSE(result.minimumRadiance.has_value());
  EXPECT_THROW(applyWindow(sun, Window::kAuto), Error);
  EXPECT_THROW(applyWindow(sun, Window::kAutoRadiance), Error);
}

}  // namespace
}  // namespace shprt
