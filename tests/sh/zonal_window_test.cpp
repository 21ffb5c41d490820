// Circular windows from 1e-160 rad to the whole sphere, against references and quadrature to degree 1000.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/sh/circular_window.h"
#include "tests/sh/quadrature.h"
#include "tests/sh/reference.h"

namespace shprt {
namespace {

constexpr double kPi = std::numbers::pi;

// f_l = integral_0^1 P_l(1 - (1-z) u) du: half as many nodes as the degree integrate it exactly. A window
// beyond the hemisphere is the whole sphere less its complement, which keeps relative accuracy.
std::vector<long double> windowByQuadrature(int degree, double radius) {
  const test::UnitRule rule = test::unitRule(degree / 2 + 1);
  const long double sine = std::sin(static_cast<long double>(radius) / 2);
  const long double cosine = std::cos(static_cast<long double>(radius) / 2);
  const bool wide = sine > cosine;
  const long double height = 2 * (wide ? cosine * cosine : sine * sine);
  std::vector<long double> sums(static_cast<std::size_t>(degree) + 1, 0.0L);
  for (std::size_t n = 0; n < rule.nodes.size(); ++n) {
    const std::vector<long double> p = test::legendre(degree, height * rule.nodes[n]);
    for (std::size_t l = 0; l < sums.size(); ++l) sums[l] += rule.weights[n] * p[l];
  }
  const long double ratio = cosine / sine;
  for (std::size_t l = 1; wide && l < sums.size(); ++l) sums[l] *= (l % 2 ? 1 : -1) * ratio * ratio;
  return sums;
}

// The recurrence as Lisle and Huang 2007 print it (eq. 11), on values instead of differences.
template <typename T>
std::vector<double> windowAsPrinted(int degree, T radius) {
  const T z = std::cos(radius);
  T previous = 1, current = (1 + z) / 2;
  std::vector<double> factors{1.0};
  for (int l = 1; l <= degree; ++l) {
    factors.push_back(static_cast<double>(current));
    const T next =
        (static_cast<T>(2 * l + 1) * z * current - static_cast<T>(l - 1) * previous) / static_cast<T>(l + 2);
    previous = current;
    current = next;
  }
  return factors;
}

// The scale of the factors of l >= 1, which vanish as the window becomes the whole sphere.
double scaleOf(double radius) {
  return std::pow(std::cos(radius / 2), 2);
}

double worstError(const std::vector<double>& factors, const std::vector<long double>& expected,
                  double radius) {
  double worst = std::fabs(static_cast<double>(factors[0] - expected[0]));
  for (std::size_t l = 1; l < factors.size(); ++l)
    worst = std::max(worst, std::fabs(static_cast<double>(factors[l] - expected[l])) / scaleOf(radius));
  return worst;
}

TEST(CircularWindow, AgreesWithTheReference) {
  SHPRT_NEEDS_REFERENCE();
  const auto reference = test::readReference("zonal.json")["circular_window"];
  ASSERT_GE(reference.size(), 9u);
  for (const auto& entry : reference) {
    const std::vector<double> factors = circularWindowFactors(100, entry["zeta"]);
    EXPECT_EQ(factors[0], 1);
    for (std::size_t l = 1; l <= 100; ++l)
      EXPECT_NEAR(factors[l], entry["f"][l].get<double>(), 1e-15 * scaleOf(entry["zeta"]))
          << entry["zeta"] << " " << l;
  }
}

TEST(CircularWindow, AgreesWithQuadratureToDegree1000) {
  for (const double radius :
       {1e-160, 1e-20, 1e-8, 1e-4, 1e-3, 0.01, 0.25, 1.0, kPi / 2, 1.6, 2.5, 3.1, 3.1415, kPi}) {
    EXPECT_LT(worstError(circularWindowFactors(1000, radius), windowByQuadrature(1000, radius), radius),
              2e-15)
        << "radius " << radius;
  }
}

TEST(CircularWindow, IsAHemisphereAndAPointAndASphere) {
  const std::vector<double> hemisphere = circularWindowFactors(3, kPi / 2);
  EXPECT_EQ(hemisphere[0], 1);
  EXPECT_NEAR(hemisphere[1], 0.5, 5e-16);
  EXPECT_NEAR(hemisphere[2], 0, 5e-16);
  EXPECT_NEAR(hemisphere[3], -0.125, 5e-16);
  for (const double factor : circularWindowFactors(1000, 1e-12)) EXPECT_NEAR(factor, 1, 1e-15);
  const std::vector<double> sphere = circularWindowFactors(1000, kPi);
  EXPECT_EQ(sphere[0], 1);
  for (std::size_t l = 1; l <= 1000; ++l) EXPECT_NEAR(sphere[l], 0, 1e-31) << l;
  EXPECT_EQ(circularWindowFactors(0, 1), std::vector<double>{1});
}

// A window and its complement make the whole sphere, whose higher factors vanish.
TEST(CircularWindow, ComplementsCancel) {
  for (const double radius : {1e-6, 0.1, 1.0, 1.5}) {
    const std::vector<double> inside = circularWindowFactors(200, radius);
    const std::vector<double> outside = circularWindowFactors(200, kPi - radius);
    const double insideAngle = circularWindowSolidAngle(radius),
                 outsideAngle = circularWindowSolidAngle(kPi - radius);
    EXPECT_NEAR(insideAngle + outsideAngle, 4 * kPi, 1e-14);
    for (std::size_t l = 1; l <= 200; ++l)
      EXPECT_NEAR(insideAngle * inside[l] + (l % 2 ? -1 : 1) * outsideAngle * outside[l], 0, 1e-14)
          << radius << " " << l;
  }
}

TEST(CircularWindow, SolidAngleKeepsItsDigits) {
  EXPECT_DOUBLE_EQ(circularWindowSolidAngle(kPi), 4 * kPi);
  EXPECT_DOUBLE_EQ(circularWindowSolidAngle(kPi / 3), kPi);
  EXPECT_DOUBLE_EQ(circularWindowSolidAngle(1e-9), kPi * 1e-18);
}

// Why the recurrence runs on differences: the printed one loses three digits and more, of a float and of a
// double, for small windows and near the whole sphere.
TEST(CircularWindow, PrintedRecurrenceLosesDigits) {
  for (const float radius : {0.0003f, 0.001f, 0.004f, 3.1415f}) {
    const auto exact = static_cast<double>(radius);
    const std::vector<long double> expected = windowByQuadrature(1000, exact);
    EXPECT_GT(worstError(windowAsPrinted(1000, radius), expected, exact), 1e-4) << radius;
    EXPECT_GT(worstError(windowAsPrinted(1000, exact), expected, exact), 1e-12) << radius;
    EXPECT_LT(worstError(circularWindowFactors(1000, exact), expected, exact), 2e-15) << radius;
  }
}

TEST(CircularWindow, RefusesARadiusOutOfRange) {
  for (const double radius : {0.0, -1.0, 3.2, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(circularWindowFactors(2, radius), Error) << radius;
}

}  // namespace
}  // namespace shprt
