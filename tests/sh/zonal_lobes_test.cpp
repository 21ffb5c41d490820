// Lobe factorisation: exact round trips, rotation by rotating directions, and how well it is conditioned.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"
#include "shprt/sh/zonal_lobes.h"

namespace shprt {
namespace {

std::vector<double> randomCoefficients(int degree) {
  std::mt19937_64 random(static_cast<std::uint64_t>(degree) + 7);
  std::vector<double> coefficients;
  for (int i = 0; i < coefficientCount(degree); ++i)
    coefficients.push_back(static_cast<double>(random() >> 11) * 0x1p-52 - 1);
  return coefficients;
}

// The largest singular value of a row-major n x n matrix, by power iteration on its square.
double spectralNorm(const std::vector<double>& a, std::size_t n) {
  std::vector<double> v(n), image(n);
  for (std::size_t i = 0; i < n; ++i) v[i] = 1 + 0.4 * std::sin(3.0 * static_cast<double>(i) + 1);
  double norm = 0;
  for (int step = 0; step < 2000; ++step) {
    std::fill(image.begin(), image.end(), 0.0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) image[i] += a[i * n + j] * v[j];
    std::fill(v.begin(), v.end(), 0.0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) v[j] += a[i * n + j] * image[i];
    norm = 0;
    for (const double entry : v) norm += entry * entry;
    norm = std::sqrt(norm);
    for (double& entry : v) entry /= norm;
  }
  return std::sqrt(norm);
}

double conditionNumber(const ZonalLobes& lobes, int l) {
  const std::size_t n = static_cast<std::size_t>(2 * l + 1), first = static_cast<std::size_t>(l * l);
  std::vector<double> forward(n * n), backward(n * n);
  std::vector<double> unit(static_cast<std::size_t>(coefficientCount(lobes.degree()))), image(unit.size());
  for (std::size_t column = 0; column < n; ++column) {
    unit[first + column] = 1;
    lobeCoefficients(lobes.directions(), unit, image);
    for (std::size_t row = 0; row < n; ++row) forward[row * n + column] = image[first + row];
    lobes.weights(unit, image);
    for (std::size_t row = 0; row < n; ++row) backward[row * n + column] = image[first + row];
    unit[first + column] = 0;
  }
  return spectralNorm(forward, n) * spectralNorm(backward, n);
}

TEST(ZonalLobes, WeightsRestoreTheFunction) {
  for (int degree = 0; degree <= kMaximumLobeDegree; ++degree) {
    const ZonalLobes lobes(degree);
    ASSERT_EQ(lobes.directions().size(), static_cast<std::size_t>(2 * degree + 1));
    const std::vector<double> coefficients = randomCoefficients(degree);
    std::vector<double> weights(coefficients.size()), restored(coefficients.size()), y(coefficients.size());
    lobes.weights(coefficients, weights);
    lobeCoefficients(lobes.directions(), weights, restored);
    for (std::size_t i = 0; i < restored.size(); ++i)
      ASSERT_NEAR(restored[i], coefficients[i], 1e-13) << "degree " << degree << " " << i;
    for (const Vec3d u : {Vec3d{0, 0, -1}, normalize({0.3, 0.8, -0.2}), normalize({-0.7, 0.1, 0.5})}) {
      evaluateSh(degree, u, y);
      double value = 0;
      for (std::size_t i = 0; i < y.size(); ++i) value += coefficients[i] * y[i];
      EXPECT_NEAR(evaluateLobes(lobes.directions(), weights, u), value, 1e-12) << "degree " << degree;
    }
  }
}

// One lobe is y_l0 about its direction: no other weight, and the coefficients that the addition theorem
// gives.
TEST(ZonalLobes, ALobeIsTheZonalHarmonicAboutItsDirection) {
  const int degree = 5;
  const ZonalLobes lobes(degree);
  std::vector<double> unit(36), coefficients(36), y(36);
  for (std::size_t d = 0; d < 7; ++d) {  // the lobes of band 3
    std::fill(unit.begin(), unit.end(), 0.0);
    unit[9 + d] = 1;
    lobeCoefficients(lobes.directions(), unit, coefficients);
    evaluateSh(degree, lobes.directions()[d], y);
    double norm = 0;
    for (std::size_t i = 0; i < 36; ++i) {
      const double expected = i >= 9 && i < 16 ? std::sqrt(4 * std::numbers::pi / 7) * y[i] : 0;
      EXPECT_NEAR(coefficients[i], expected, 1e-15) << i;
      norm += coefficients[i] * coefficients[i];
    }
    EXPECT_NEAR(norm, 1, 1e-14);
    const double atItsAxis = std::sqrt(7 / (4 * std::numbers::pi));
    EXPECT_NEAR(evaluateLobes(lobes.directions(), unit, lobes.directions()[d]), atItsAxis, 1e-14);
  }
}

TEST(ZonalLobes, RotatingTheDirectionsRotatesTheFunction) {
  for (const char* turn : {"axis:0,0,1,90", "axis:1,0,0,180", "axis:1,2,3,40", "axis:-0.3,1,0.2,1e-6",
                           "euler:zyz,10,0,20", "euler:zyz,130,5.7,-70", "axis:0,1,0,0"}) {
    const Mat3 matrix = parseRotation(turn);
    for (const int degree : {0, 1, 2, 4, 5, 8, 13, 16}) {
      std::vector<double> expected = randomCoefficients(degree), rotated = expected;
      ShRotation(degree, matrix).apply(expected);
      ZonalLobes(degree).rotate(matrix, rotated);
      for (std::size_t i = 0; i < rotated.size(); ++i)
        ASSERT_NEAR(rotated[i], expected[i], 2e-13) << turn << ", degree " << degree << " " << i;
    }
  }
}

TEST(ZonalLobes, AreWellConditionedInEveryBand) {
  for (int degree = 0; degree <= kMaximumLobeDegree; ++degree) {
    const ZonalLobes lobes(degree);
    const double bound = degree <= 2 ? 2.2 : degree <= 4 ? 2.9 : degree <= 8 ? 5.2 : 11.1;
    for (int l = 0; l <= degree; ++l)
      EXPECT_LT(conditionNumber(lobes, l), bound) << "degree " << degree << ", band " << l;
  }
}

TEST(ZonalLobes, DirectionsAreUnitAndOneSequencePerTable) {
  for (int degree = 0; degree <= kMaximumLobeDegree; ++degree) {
    const std::vector<Vec3d> directions = lobeDirections(degree);
    for (const Vec3d& d : directions) EXPECT_NEAR(length(d), 1, 1e-15);
    const std::vector<Vec3d> all = lobeDirections(degree <= 2 ? 2 : degree <= 4 ? 4 : degree <= 8 ? 8 : 16);
    EXPECT_TRUE(std::equal(directions.begin(), directions.end(), all.begin())) << degree;
  }
}

TEST(ZonalLobes, RefusesADegreeWithoutDirections) {
  EXPECT_THROW(ZonalLobes(kMaximumLobeDegree + 1), Error);
  EXPECT_THROW(ZonalLobes(-1), Error);
}

}  // namespace
}  // namespace shprt
