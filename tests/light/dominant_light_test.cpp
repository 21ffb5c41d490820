// The dominant light: exact where one is there, and nowhere a better one beside it.
#include "shprt/light/dominant_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shprt/light/project_probe.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"
#include "shprt/sh/zonal.h"

namespace shprt {
namespace {

using std::numbers::pi;

// The integral over normals of the squared error of the irradiance, by definition: from coefficients of the
// irradiance itself, of which the basis makes an orthonormal set.
double irradianceError(const LightCoefficients& light, Vec3d direction, double irradiance, double ambient,
                       std::size_t colour) {
  const LightCoefficients model =
      addLights(projectDirectional(direction, {irradiance, irradiance, irradiance}, light.degree),
                projectConstant({ambient, ambient, ambient}, light.degree));
  const std::vector<double> cosine = clampedCosineFactors(light.degree);
  double error = 0;
  for (std::size_t i = 0; i < light.coefficients.size(); ++i) {
    const double difference = cosine[static_cast<std::size_t>(bandOf(static_cast<int>(i)))] *
                              (light.coefficients[i][colour] - model.coefficients[i][colour]);
    error += difference * difference;
  }
  return error;
}

TEST(DominantLight, OfASunUnderAnEvenSkyIsExact) {
  for (const int degree : {1, 2, 3, 6, 40})
    for (const Vec3d towards : {Vec3d{1, 2, 3}, Vec3d{0, 0, -1}, Vec3d{-0.3, 0.9, 1e-9}}) {
      const LightCoefficients light =
          addLights(projectDirectional(towards, {3, 2, 1}, degree), projectConstant({0.25, 0.5, 1}, degree));
      const DominantLight dominant = dominantLight(light);
      EXPECT_NEAR(length(dominant.direction - normalize(towards)), 0, 1e-14);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(dominant.irradiance[c], 3 - static_cast<double>(c), 2e-14) << degree;
        EXPECT_NEAR(dominant.ambientRadiance[c], std::ldexp(0.25, static_cast<int>(c)), 2e-14) << degree;
        EXPECT_NEAR(dominant.unexplained[c], 0, 1e-14);
      }
    }
}

TEST(DominantLight, OfASunAloneLeavesNothing) {
  const DominantLight dominant = dominantLight(projectDirectional({2, -1, 2}, {5, 0, 1}, 4));
  const double expected[] = {5, 0, 1};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(dominant.irradiance[c], expected[c], 1e-14);
    EXPECT_NEAR(dominant.ambientRadiance[c], 0, 1e-14);
    EXPECT_GE(dominant.ambientRadiance[c], 0);
  }
}

TEST(DominantLight, IsAbsentFromEvenLight) {
  for (const int degree : {0, 3}) {
    const DominantLight dominant = dominantLight(projectConstant({1, 2, 0}, degree));
    EXPECT_EQ(dominant.direction, Vec3d{});
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(dominant.irradiance[c], 0);
      EXPECT_EQ(dominant.unexplained[c], 0);
    }
    EXPECT_NEAR(dominant.ambientRadiance[0], 1, 1e-15);
    EXPECT_NEAR(dominant.ambientRadiance[1], 2, 1e-15);
    EXPECT_EQ(dominant.ambientRadiance[2], 0);
  }
}

// Two equal suns at right angles: the direction is between them. At degree 1 their vectors add up, to sqrt 2
// of one sun. At degree 2, with cosines c = 1/sqrt 2 to both and P_2(c) = 1/4, the sums over m give
// e = 2 (3 A_1^2 c + 5 A_2^2 / 4) / (3 A_1^2 + 5 A_2^2).
TEST(DominantLight, OfTwoSunsLiesBetween) {
  const auto pair = [](int degree) {
    return addLights(projectDirectional({1, 0, 0}, {1, 1, 1}, degree),
                     projectDirectional({0, 1, 0}, {1, 1, 1}, degree));
  };
  const double c = 1 / std::numbers::sqrt2, a1 = 2 * pi / 3, a2 = pi / 4;
  const DominantLight first = dominantLight(pair(1)), second = dominantLight(pair(2));
  EXPECT_NEAR(length(first.direction - Vec3d{c, c, 0}), 0, 1e-15);
  EXPECT_NEAR(first.irradiance[0], std::numbers::sqrt2, 1e-14);
  EXPECT_NEAR(first.ambientRadiance[0], (2 - std::numbers::sqrt2) / (4 * pi), 1e-15);
  EXPECT_NEAR(first.unexplained[0], 0, 1e-14);
  const double expected = 2 * (3 * a1 * a1 * c + 5 * a2 * a2 / 4) / (3 * a1 * a1 + 5 * a2 * a2);
  EXPECT_NEAR(second.irradiance[1], expected, 1e-14);
  EXPECT_NEAR(second.ambientRadiance[1], (2 - expected) / (4 * pi), 1e-15);
  EXPECT_GT(second.unexplained[1], 0.01);
  EXPECT_LT(second.unexplained[1], 0.2);
  // A brighter one pulls the direction to itself.
  const LightCoefficients uneven =
      addLights(projectDirectional({1, 0, 0}, {3, 3, 3}, 2), projectDirectional({0, 1, 0}, {1, 1, 1}, 2));
  EXPECT_NEAR(dominantLight(uneven).direction.x, 3 / std::sqrt(10.0), 1e-15);
}

// Least squares under bounds: no feasible neighbour is better. The cases meet each bound: a rest that would
// be negative, a colour that the direction darkens, and negative light.
TEST(DominantLight, IsTheBestAmongAdmissibleOnes) {
  std::vector<LightCoefficients> lights;
  LightCoefficients uneven;
  uneven.degree = 4;
  for (int i = 0; i < 25; ++i)
    uneven.coefficients.push_back({std::cos(i * i + 1.0), std::sin(3.0 * i + 0.5), std::cos(5.0 * i)});
  lights.push_back(uneven);
  uneven.coefficients[0] = {-1, 0.01, 3};
  lights.push_back(uneven);
  LightCoefficients opposed = projectDirectional({0, 1, 0}, {0, 4, 0}, 3);
  opposed = addLights(opposed, projectDirectional({0, -1, 0}, {1, 0, 1}, 3));
  lights.push_back(opposed);
  for (const LightCoefficients& light : lights) {
    const DominantLight dominant = dominantLight(light);
    for (std::size_t c = 0; c < 3; ++c) {
      const double e = dominant.irradiance[c], a = dominant.ambientRadiance[c];
      EXPECT_GE(e, 0);
      EXPECT_GE(a, 0);
      const double error = irradianceError(light, dominant.direction, e, a, c);
      for (const double stepE : {-1e-3, 0.0, 1e-3})
        for (const double stepA : {-1e-3, 0.0, 1e-3}) {
          const double other = irradianceError(light, dominant.direction, std::max(0.0, e + stepE),
                                               std::max(0.0, a + stepA), c);
          EXPECT_GE(other, error - 1e-12) << c << ": " << stepE << ", " << stepA;
        }
    }
  }
  EXPECT_EQ(dominantLight(opposed).irradiance[0], 0);
  EXPECT_GT(dominantLight(opposed).ambientRadiance[0], 0);
}

TEST(DominantLight, TurnsWithTheLight) {
  const LightCoefficients light =
      addLights(projectDirectional({1, 2, 3}, {3, 2, 1}, 5), projectDirectional({-1, 0, 1}, {1, 2, 1}, 5));
  const Mat3 turn = parseRotation("axis:1,2,-1,77");
  const DominantLight here = dominantLight(light), there = dominantLight(rotateLight(light, turn));
  EXPECT_NEAR(length(there.direction - turn * here.direction), 0, 1e-13);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(there.irradiance[c], here.irradiance[c], 1e-13);
    EXPECT_NEAR(there.ambientRadiance[c], here.ambientRadiance[c], 1e-13);
  }
}

}  // namespace
}  // namespace shprt
