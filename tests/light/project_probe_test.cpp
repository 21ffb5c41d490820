// Projection of images against functions whose coefficients are known.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "painted_maps.h"
#include "shprt/base/error.h"
#include "shprt/base/parallel.h"
#include "shprt/light/ball_weights.h"
#include "shprt/light/project_probe.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

using std::numbers::pi;

// Every harmonic to degree 4 and some to degree 8, three to an image. The basis of a layout's pixels is
// evaluated once.
TEST(ProjectProbe, ASphericalHarmonicComesBackAsItsCoefficient) {
  const int degree = 8;
  const auto count = static_cast<std::size_t>(coefficientCount(degree));
  std::vector<std::size_t> harmonics;
  for (std::size_t i = 0; i < 25; ++i) harmonics.push_back(i);
  for (const std::size_t i : {30, 33, 42, 48, 56, 64, 65, 70, 72, 77, 80}) harmonics.push_back(i);
  for (const PaintedCase& c : kPaintedCases) {
    std::vector<std::vector<double>> basis;
    EnvironmentMap map = paintMap(c, [&](Vec3d direction) {
      basis.emplace_back(count);
      evaluateSh(degree, direction, basis.back());
      return Vec3f{1, 0, 0};  // marks the pixels that show something
    });
    std::vector<Vec3f*> pixels;
    for (Vec3f& pixel : map.image.pixels) {
      if (pixel.x > 0) pixels.push_back(&pixel);
    }
    ASSERT_EQ(pixels.size(), basis.size());
    for (std::size_t first = 0; first < harmonics.size(); first += 3) {
      const std::size_t* own = &harmonics[first];
      for (std::size_t k = 0; k < pixels.size(); ++k)
        *pixels[k] = toFloat({basis[k][own[0]], basis[k][own[1]], basis[k][own[2]]});
      const LightCoefficients light = projectProbe(map, {.degree = degree}).light;
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t colour = 0; colour < 3; ++colour)
          ASSERT_NEAR(light.coefficients[i][colour], i == own[colour] ? 1 : 0, 1e-4)
              << layoutName(c.layout) << ", harmonic " << own[colour] << ", coefficient " << i;
    }
  }
}

// Odd widths, odd halves and single columns go through the same folding of rows; a plain sum over pixels is
// what they must equal.
TEST(ProjectProbe, LatitudeRowsEqualThePlainSum) {
  const int degree = 6;
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {3, 2}, {6, 5}, {7, 4}, {10, 6}, {33, 17}}) {
    EnvironmentMap map;
    map.image = {width, height, {}};
    for (int i = 0; i < width * height; ++i)
      map.image.pixels.push_back(
          {float(std::sin(1.3 * i) + 1.5), float(std::cos(2.1 * i) + 1.5), float(i % 7)});
    map.image.at(width / 2, height / 2).x = -1;  // also through the path of rows that need mending
    std::vector<double> basis(static_cast<std::size_t>(coefficientCount(degree)));
    std::vector<Vec3d> expected(basis.size());
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const PixelFootprint footprint = pixelFootprint(map.layout, width, height, x, y);
        evaluateSh(degree, footprint.direction, basis);
        for (std::size_t i = 0; i < basis.size(); ++i)
          expected[i] += toDouble(map.image.at(x, y)) * (footprint.solidAngle * basis[i]);
      }
    const LightCoefficients light = projectProbe(map, {.degree = degree}).light;
    for (std::size_t i = 0; i < basis.size(); ++i) {
      EXPECT_NEAR(light.coefficients[i][0], expected[i].x, 1e-12) << width << " x " << height << ", " << i;
      EXPECT_NEAR(light.coefficients[i][1], expected[i].y, 1e-12) << width << " x " << height << ", " << i;
      EXPECT_NEAR(light.coefficients[i][2], expected[i].z, 1e-12) << width << " x " << height << ", " << i;
    }
  }
}

TEST(ProjectProbe, ConstantImagesAreExact) {
  for (const PaintedCase& c : kPaintedCases)
    for (const int degree : {0, 3}) {
      const ProbeProjection projection = projectProbe(paintMap(c,
                                                               [](Vec3d) {
                                                                 return Vec3f{1, 2, 0.5f};
                                                               }),
                                                      {.degree = degree});
      EXPECT_NEAR(projection.light.coefficients[0][1] / std::sqrt(4 * pi), 2, 1e-12) << layoutName(c.layout);
      EXPECT_NEAR(projection.energy[0] / (4 * pi), 1, 1e-12) << layoutName(c.layout);
      EXPECT_NEAR(projection.solidAngle / (4 * pi), 1, 1e-10) << layoutName(c.layout);
      EXPECT_NEAR(projection.energyMissed[0], 0, 1e-12) << layoutName(c.layout);
    }
}

// Half the energy of 1 + sqrt(4 pi) y_lm lies in each part, so a degree below l misses half.
TEST(ProjectProbe, TellsWhichEnergyTheDegreeMisses) {
  std::vector<double> y(static_cast<std::size_t>(coefficientCount(5)));
  const EnvironmentMap map = paintMap(kPaintedCases[0], [&](Vec3d direction) {
    evaluateSh(5, direction, y);
    const auto value = static_cast<float>(1 + std::sqrt(4 * pi) * y[static_cast<std::size_t>(shIndex(5, 2))]);
    return Vec3f{value, value, 0};
  });
  const ProbeProjection below = projectProbe(map, {.degree = 4}), held = projectProbe(map, {.degree = 5});
  EXPECT_NEAR(below.energy[0] / (4 * pi), 2, 1e-3);
  EXPECT_NEAR(below.energyMissed[0], 0.5, 1e-4);
  EXPECT_NEAR(held.energyMissed[1], 0, 1e-4);
  EXPECT_EQ(held.energyMissed[2], 0);
}

TEST(ProjectProbe, CountsAndMendsBadPixels) {
  EnvironmentMap map = paintMap({EnvironmentLayout::kLatitudeLongitude, 64, 32}, [](Vec3d) {
    return Vec3f{1, 1, 1};
  });
  map.image.at(3, 4) = {NAN, 1, 1};
  map.image.at(50, 20) = {1, INFINITY, 1};
  map.image.at(10, 10) = {-1, 1, 1};
  const ProbeProjection projection = projectProbe(map, {.degree = 2});
  EXPECT_EQ(projection.nonFinitePixels, 2u);
  EXPECT_EQ(projection.negativePixels, 1u);
  EXPECT_LT(projection.solidAngle, 4 * pi);
  // The rest stands for what was left out, so green stays the radiance of the others; the negative pixel
  // counts as it is.
  EXPECT_NEAR(projection.light.coefficients[0][1], std::sqrt(4 * pi), 1e-12);
  const double own = pixelFootprint(map.layout, 64, 32, 10, 10).solidAngle / projection.solidAngle;
  EXPECT_NEAR(projection.light.coefficients[0][0], std::sqrt(4 * pi) * (1 - 2 * own), 1e-12);
  EXPECT_NEAR(projectProbe(map, {.degree = 2, .clampNegative = true}).light.coefficients[0][0],
              std::sqrt(4 * pi) * (1 - own), 1e-12);
  EXPECT_THROW(projectProbe(map, {.degree = 2, .strict = true}), Error);
  for (Vec3f& pixel : map.image.pixels) pixel = {NAN, 0, 0};
  EXPECT_THROW(projectProbe(map, {.degree = 2}), Error);
}

TEST(ProjectProbe, LargeValuesDoNotOverflow) {
  const EnvironmentMap map = paintMap({EnvironmentLayout::kLatitudeLongitude, 32, 16}, [](Vec3d) {
    return Vec3f{3e38f, 57600, 1e-38f};
  });
  const ProbeProjection projection = projectProbe(map, {.degree = 4});
  EXPECT_NEAR(projection.light.coefficients[0][0] / (3e38 * std::sqrt(4 * pi)), 1, 1e-6);
  EXPECT_TRUE(std::isfinite(projection.energy[0]));
}

TEST(ProjectProbe, GivesTheSameBitsForAnyNumberOfThreads) {
  const auto scene = [](Vec3d d) {
    return Vec3f{float(1 + d.x * d.y), float(1 + d.z), float(2 + std::sin(9 * d.y))};
  };
  for (const PaintedCase& c : kPaintedCases) {
    const EnvironmentMap map = paintMap(c, scene);
    setThreadCount(1);
    const LightCoefficients one = projectProbe(map, {.degree = 4}).light;
    setThreadCount(2);
    EXPECT_EQ(one.coefficients, projectProbe(map, {.degree = 4}).light.coefficients);
  }
  setThreadCount(0);
}

// What the weights are for: sums of Legendre polynomials of z over the pixels are exact. Pictures too coarse
// for a degree get what they can hold, and weights near 1.
TEST(BallWeights, IntegrateLegendrePolynomialsExactly) {
  for (const EnvironmentLayout ball : {EnvironmentLayout::kAngularMap, EnvironmentLayout::kMirroredBall})
    for (const int size : {1, 2, 9, 64, 201}) {
      const BallWeights weights(ball, size, size, 16);
      if (size >= 201) {
        EXPECT_EQ(weights.degree(), 16) << layoutName(ball);
      }
      for (int j = 0; j <= weights.degree(); ++j) {
        double sum = 0;
        for (int y = 0; y < size; ++y)
          for (int x = 0; x < size; ++x) {
            const auto [direction, solidAngle] = pixelFootprint(ball, size, size, x, y);
            if (solidAngle > 0)
              sum += solidAngle * weights.factor(direction.z) *
                     std::legendre(static_cast<unsigned>(j), direction.z);
          }
        EXPECT_NEAR(sum, j == 0 ? 4 * pi : 0, 1e-11) << layoutName(ball) << " " << size << ", degree " << j;
      }
      for (double z = -1; z <= 1; z += 0.01) {
        EXPECT_GE(weights.factor(z), 0.2) << layoutName(ball) << " " << size;
        EXPECT_LE(weights.factor(z), 5) << layoutName(ball) << " " << size;
      }
    }
}

}  // namespace
}  // namespace shprt
