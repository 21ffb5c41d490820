// Analytic lights, and what is done to coefficients.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "painted_maps.h"
#include "shprt/base/error.h"
#include "shprt/light/project_probe.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"
#include "shprt/sh/zonal.h"

namespace shprt {
namespace {

using std::numbers::pi;

TEST(Analytic, DirectionalAndConstantLights) {
  const LightCoefficients sun = projectDirectional({0, 5, 0}, {2, 1, 0}, 3);
  std::vector<double> y(16);
  evaluateSh(3, Vec3d{0, 1, 0}, y);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(sun.coefficients[i][0], 2 * y[i], 1e-15);
  // Irradiance on a surface that faces it, in the limit of all bands: here through the cosine's factors.
  const std::vector<double> cosine = clampedCosineFactors(64);
  const LightCoefficients fine = projectDirectional({0, 0, 1}, {2, 1, 0}, 64);
  std::vector<double> up(static_cast<std::size_t>(coefficientCount(64)));
  evaluateSh(64, Vec3d{0, 0, 1}, up);
  double irradiance = 0;
  for (int i = 0; i < coefficientCount(64); ++i)
    irradiance += cosine[static_cast<std::size_t>(bandOf(i))] *
                  fine.coefficients[static_cast<std::size_t>(i)][0] * up[static_cast<std::size_t>(i)];
  EXPECT_NEAR(irradiance, 2, 0.02);
  EXPECT_THROW(projectDirectional({0, 0, 0}, {1, 1, 1}, 2), Error);
  EXPECT_NEAR(projectConstant({1, 2, 3}, 2).coefficients[0][2], 3 * std::sqrt(4 * pi), 1e-14);
  EXPECT_EQ(projectConstant({1, 2, 3}, 2).coefficients[5][2], 0);
}

TEST(Analytic, DirectionsOfAnyLengthButNone) {
  const LightCoefficients sun = projectDirectional({3, 0, 4}, {1, 1, 1}, 2);
  for (const double scale : {1e-300, 1e-3, 1e300}) {
    const LightCoefficients scaled = projectDirectional(Vec3d{3, 0, 4} * scale, {1, 1, 1}, 2);
    for (std::size_t i = 0; i < 9; ++i)
      EXPECT_NEAR(scaled.coefficients[i][0], sun.coefficients[i][0], 1e-15) << scale;
  }
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(projectDirectional({bad, 1, 0}, {1, 1, 1}, 2), Error);
}

TEST(Analytic, SumsDegreesAndRotations) {
  const LightCoefficients a = projectDirectional({1, 0, 0}, {1, 1, 1}, 4), b = projectConstant({1, 1, 1}, 2);
  EXPECT_EQ(addLights(a, b).degree, 2);
  EXPECT_EQ(addLights(a, b).coefficients.size(), 9u);
  EXPECT_EQ(withDegree(b, 4).coefficients.size(), 25u);
  const LightCoefficients turned = rotateLight(a, parseRotation("axis:0,1,0,90")),
                          there = projectDirectional({0, 0, -1}, {1, 1, 1}, 4);
  for (std::size_t i = 0; i < 25; ++i)
    EXPECT_NEAR(turned.coefficients[i][0], there.coefficients[i][0], 1e-14);
}

TEST(Analytic, ChangedLightsCarryNoStatistics) {
  LightCoefficients light = projectConstant({1, 1, 1}, 1);
  light.statisticsJson = "{}";
  EXPECT_EQ(withDegree(light, 0).statisticsJson, "");
  EXPECT_EQ(withDegree(light, 1).statisticsJson, "{}");
  EXPECT_EQ(addLights(light, light).statisticsJson, "");
  EXPECT_EQ(scaleLight(light, 2).statisticsJson, "");
  EXPECT_EQ(rotateLight(light, Mat3{}).statisticsJson, "");
  EXPECT_EQ(scaleLight(light, 2).coefficients[0][1], 2 * light.coefficients[0][1]);
}

// Turning the light's coefficients is turning the image: here by painting the turned scene.
TEST(Analytic, RotatingCoefficientsIsRotatingTheImage) {
  const Mat3 rotation = parseRotation("euler:zyz,20,35,-70");
  const auto scene = [](Vec3d d) {
    return Vec3f{float(1 + d.x + 0.5 * d.y * d.z), float(2 + d.x * d.x - d.z), 1};
  };
  const PaintedCase c = kPaintedCases[0];
  const LightCoefficients turned =
      rotateLight(projectProbe(paintMap(c, scene), {.degree = 4}).light, rotation);
  const LightCoefficients painted =
      projectProbe(paintMap(c, [&](Vec3d d) { return scene(transpose(rotation) * d); }), {.degree = 4}).light;
  for (std::size_t i = 0; i < 25; ++i)
    for (std::size_t colour = 0; colour < 3; ++colour)
      EXPECT_NEAR(turned.coefficients[i][colour], painted.coefficients[i][colour], 2e-4) << i;
}

}  // namespace
}  // namespace shprt
