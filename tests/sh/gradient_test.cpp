// Gradients of spherical harmonics against differences, sum rules, and what is known at the poles.
#include "shprt/sh/gradient.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "shprt/sh/basis.h"

namespace shprt {
namespace {

struct Field {
  std::vector<double> values;
  std::vector<Vec3d> gradients;
};

Field evaluateField(int degree, Vec3d direction) {
  const std::size_t count = static_cast<std::size_t>(coefficientCount(degree));
  Field field{std::vector<double>(count), std::vector<Vec3d>(count)};
  evaluateShGradient(degree, direction, field.values, field.gradients);
  return field;
}

const std::vector<Vec3d>& directions() {
  static const std::vector<Vec3d> list = {{0, 0, 1},
                                          {0, 0, -1},
                                          {1, 0, 0},
                                          {0, -1, 0},
                                          normalize({1e-20, 0, 1}),
                                          normalize({1e-8, -2e-8, -1}),
                                          normalize({1e-3, 1e-3, 1}),
                                          normalize({0.3, -0.5, 0.7}),
                                          normalize({-0.8, 0.1, -0.2}),
                                          normalize({1, 1, 1e-9})};
  return list;
}

TEST(Gradient, OfBandOneIsThatOfTheCoordinates) {
  const double c = std::sqrt(3 / (4 * std::numbers::pi));
  for (const Vec3d u : directions()) {
    const Field field = evaluateField(1, u);
    const Vec3d axes[] = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    EXPECT_EQ(field.gradients[0], Vec3d());
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d expected = c * (axes[i] - u * dot(axes[i], u));
      EXPECT_LT(length(field.gradients[i + 1] - expected), 1e-15)
          << i << " at " << u.x << " " << u.y << " " << u.z;
    }
  }
}

// Along a great circle through u, of speed 1. The difference has an error of about (l h)^2 / 6 and one of
// 1e-15 / h.
TEST(Gradient, AgreesWithCentralDifferences) {
  const int degree = 12;
  const double h = 1e-5;
  for (const Vec3d u : directions()) {
    const Field field = evaluateField(degree, u);
    const Vec3d a = normalize(cross(u, std::abs(u.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
    for (const Vec3d along : {a, cross(u, a)}) {
      const Field ahead = evaluateField(degree, normalize(u * std::cos(h) + along * std::sin(h)));
      const Field behind = evaluateField(degree, normalize(u * std::cos(h) - along * std::sin(h)));
      for (std::size_t i = 0; i < field.values.size(); ++i) {
        ASSERT_NEAR(dot(field.gradients[i], along), (ahead.values[i] - behind.values[i]) / (2 * h), 3e-7)
            << i << " at " << u.x << " " << u.y << " " << u.z;
      }
    }
  }
}

// The sums of a band are those of the addition theorem: sum y^2 = (2l+1)/4pi, sum y grad y = 0, and sum |grad
// y|^2 = l(l+1)(2l+1)/4pi, half of it in each tangent direction.
TEST(Gradient, FulfilsTheSumRulesAndIsTangent) {
  const int degree = 300;
  for (const Vec3d u : directions()) {
    const Field field = evaluateField(degree, u);
    for (int l = 1; l <= degree; ++l) {
      const double scale = (2 * l + 1) / (4 * std::numbers::pi), bound = double(l) * (l + 1) * scale;
      double sum = 0;
      Vec3d mixed;
      Mat3 tensor{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
      for (int m = -l; m <= l; ++m) {
        const std::size_t i = static_cast<std::size_t>(shIndex(l, m));
        const Vec3d g = field.gradients[i];
        sum += dot(g, g);
        mixed += g * field.values[i];
        const double components[] = {g.x, g.y, g.z};
        for (int row = 0; row < 3; ++row)
          for (int column = 0; column < 3; ++column)
            tensor.m[row][column] += components[row] * components[column];
        ASSERT_NEAR(dot(g, u), 0, 1e-15 * std::sqrt(bound)) << l << " " << m;
      }
      ASSERT_NEAR(sum / bound, 1, 1e-13) << l;
      ASSERT_LT(length(mixed), 1e-13 * std::sqrt(bound * scale)) << l;
      const double components[] = {u.x, u.y, u.z};
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
          const double expected = 0.5 * ((row == column) - components[row] * components[column]);
          ASSERT_NEAR(tensor.m[row][column] / bound, expected, 1e-13) << l << " " << row << " " << column;
        }
    }
  }
}

// Only order 1 has a gradient at a pole: y_l1 is x sqrt((2l+1)/4pi) sqrt(l(l+1)/2) there, times (-1)^(l+1) in
// the south.
TEST(Gradient, IsExactAtThePoles) {
  for (const double pole : {1.0, -1.0}) {
    const Field field = evaluateField(1000, {0, 0, pole});
    for (const int l : {1, 2, 3, 20, 1000}) {
      const double slope = std::sqrt((2 * l + 1) / (4 * std::numbers::pi) * l * (l + 1) / 2) *
                           (pole < 0 && l % 2 == 0 ? -1 : 1);
      for (int m = -l; m <= l; ++m) {
        const Vec3d expected = {m == 1 ? slope : 0, m == -1 ? slope : 0, 0};
        const Vec3d g = field.gradients[static_cast<std::size_t>(shIndex(l, m))];
        ASSERT_LT(length(g - expected), 1e-14 * std::abs(slope)) << l << " " << m;
      }
    }
  }
}

}  // namespace
}  // namespace shprt
