// Band factors of the lobes, zonal vectors and convolution, against references, closed forms and quadrature.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/zonal.h"
#include "tests/sh/quadrature.h"
#include "tests/sh/reference.h"

namespace shprt {
namespace {

constexpr double kPi = std::numbers::pi;

// integral_0^infinity e^-tau P_l(1 - x(tau)) d tau, which is (s+1) integral_0^1 t^s P_l dt for t =
// e^(-tau/(s+1)): every exponent is equally easy.
std::vector<long double> exponentialIntegral(int degree, const std::function<long double(long double)>& x) {
  static const test::UnitRule rule = test::unitRule(320);
  constexpr int kPanels = 24, kWidth = 2;  // what lies beyond is below 1e-20
  std::vector<long double> sums(static_cast<std::size_t>(degree) + 1, 0.0L);
  for (int panel = 0; panel < kPanels; ++panel)
    for (std::size_t n = 0; n < rule.nodes.size(); ++n) {
      const long double tau = kWidth * (panel + rule.nodes[n]),
                        weight = kWidth * rule.weights[n] * std::exp(-tau);
      const std::vector<long double> p = test::legendre(degree, x(tau));
      for (std::size_t l = 0; l < sums.size(); ++l) sums[l] += weight * p[l];
    }
  return sums;
}

double worstDifference(const std::vector<double>& factors, const std::vector<long double>& expected) {
  double worst = 0;
  for (std::size_t l = 0; l < factors.size(); ++l)
    worst = std::max(worst, std::fabs(static_cast<double>(factors[l] - expected[l])));
  return worst;
}

TEST(ZonalFactors, PhongLobeAgreesWithQuadratureForEveryExponent) {
  for (const double s : {0.0, 0.3, 1.0, 2.0, 7.5, 64.0, 1000.25, 1e6}) {
    const int degree = s < 10 ? 100 : 1000;
    const auto expected = exponentialIntegral(
        degree, [s](long double tau) { return -std::expm1(-tau / (static_cast<long double>(s) + 1)); });
    EXPECT_LT(worstDifference(phongLobeFactors(degree, s), expected), 2e-15) << "exponent " << s;
  }
}

TEST(ZonalFactors, PowerLobeAgreesWithQuadratureForEveryExponent) {
  for (const double s : {0.0, 0.3, 1.0, 2.0, 7.5, 64.0, 1000.25, 1e6}) {
    const int degree = s < 10 ? 100 : 1000;
    const auto expected = exponentialIntegral(
        degree, [s](long double tau) { return -2 * std::expm1(-tau / (static_cast<long double>(s) + 1)); });
    EXPECT_LT(worstDifference(powerLobeFactors(degree, s), expected), 2e-15) << "exponent " << s;
  }
}

// The closed forms in Gamma functions, for exponents where none of them has a pole: small factors keep their
// digits.
TEST(ZonalFactors, LobesAreAccurateRelativeToEachFactor) {
  for (const long double s : {0.25L, 2.5L, 20.75L}) {
    const auto phong = phongLobeFactors(100, static_cast<double>(s));
    const auto power = powerLobeFactors(100, static_cast<double>(s));
    const long double phongScale =
        std::sqrt(std::numbers::pi_v<long double>) * std::tgamma(s + 2) / std::exp2(s + 1);
    const long double powerScale = std::tgamma(s + 1) * std::tgamma(s + 2);
    for (int l = 0; l <= 100; ++l) {
      const auto i = static_cast<std::size_t>(l);
      const auto phongExpected =
          static_cast<double>(phongScale / (std::tgamma((s - l) / 2 + 1) * std::tgamma((s + l + 3) / 2)));
      const auto powerExpected =
          static_cast<double>(powerScale / (std::tgamma(s - l + 1) * std::tgamma(s + l + 2)));
      EXPECT_NEAR(phong[i], phongExpected, (l + 1) * 3e-16 * std::fabs(phongExpected))
          << double(s) << " " << l;
      EXPECT_NEAR(power[i], powerExpected, (l + 1) * 5e-16 * std::fabs(powerExpected))
          << double(s) << " " << l;
    }
  }
}

TEST(ZonalFactors, LobesHaveTheirKnownSpecialCases) {
  const std::vector<double> phong = phongLobeFactors(30, 1), cosine = clampedCosineFactors(30);
  for (std::size_t l = 0; l <= 30; ++l) EXPECT_NEAR(phong[l], cosine[l] / kPi, 1e-16) << l;
  const std::vector<double> hemisphere = phongLobeFactors(4, 0);
  EXPECT_EQ(hemisphere, (std::vector<double>{1, 0.5, 0, -0.125, 0}));
  const std::vector<double> linear = powerLobeFactors(5, 1);  // (1+t)/(4 pi)
  EXPECT_DOUBLE_EQ(linear[1], 1.0 / 3);
  for (std::size_t l = 2; l <= 5; ++l) EXPECT_EQ(linear[l], 0) << l;
  EXPECT_EQ(powerLobeFactors(2, 0), (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(henyeyGreensteinFactors(3, -0.5), (std::vector<double>{1, -0.5, 0.25, -0.125}));
  EXPECT_EQ(henyeyGreensteinFactors(2, 0), (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(phongLobeFactors(0, 3), std::vector<double>{1});
  EXPECT_EQ(powerLobeFactors(0, 3), std::vector<double>{1});
  EXPECT_EQ(henyeyGreensteinFactors(0, 0.3), std::vector<double>{1});
}

TEST(ZonalFactors, HenyeyGreensteinAgreesWithTheReference) {
  SHPRT_NEEDS_REFERENCE();
  const auto reference = test::readReference("zonal.json")["henyey_greenstein"];
  ASSERT_GE(reference.size(), 4u);
  for (const auto& entry : reference) {
    const std::vector<double> factors = henyeyGreensteinFactors(100, entry["g"]);
    for (std::size_t l = 0; l <= 100; ++l) {
      const double expected = entry["lambda"][l].get<double>();
      EXPECT_NEAR(factors[l], expected, 2e-14 * std::fabs(expected)) << entry["g"] << " " << l;
    }
  }
}

TEST(ZonalFactors, SumUpToTheKernel) {
  for (const double t : {-1.0, -0.7, 0.0, 0.4, 0.99, 1.0}) {
    for (const double g : {0.6, -0.3}) {
      const double phase = (1 - g * g) / (4 * kPi * std::pow(1 + g * g - 2 * g * t, 1.5));
      EXPECT_NEAR(evaluateZonal(henyeyGreensteinFactors(100, g), t), phase, 1e-13 * (1 + phase))
          << g << " " << t;
    }
    EXPECT_NEAR(evaluateZonal(powerLobeFactors(7, 7), t), 8 / (4 * kPi) * std::pow((1 + t) / 2, 7), 1e-15)
        << t;
    EXPECT_NEAR(evaluateZonal(powerLobeFactors(200, 40.5), t), 41.5 / (4 * kPi) * std::pow((1 + t) / 2, 40.5),
                1e-13)
        << t;
  }
}

TEST(ZonalFactors, ZonalVectorHasTheValuesOfItsKernelAboutAnyAxis) {
  const std::vector<double> factors = powerLobeFactors(12, 12);
  std::vector<double> coefficients(169), y(169);
  for (const Vec3d axis : {Vec3d{0, 0, 1}, Vec3d{0, 0, -1}, Vec3d{1, 0, 0}, normalize({0.3, -0.5, 0.7})}) {
    zonalCoefficients(axis, factors, coefficients);
    for (const Vec3d u : {Vec3d{0, 1, 0}, normalize({-0.2, 0.4, 0.9}), normalize({0.9, 0.1, -0.4}), axis}) {
      evaluateSh(12, u, y);
      double value = 0;
      for (std::size_t i = 0; i < y.size(); ++i) value += coefficients[i] * y[i];
      EXPECT_NEAR(value, 13 / (4 * kPi) * std::pow((1 + dot(u, axis)) / 2, 12), 1e-14);
    }
  }
}

// Convolving one zonal function with another about the same axis multiplies their factors; a directional
// light convolved with a kernel is the kernel about the light.
TEST(ZonalFactors, ConvolutionMultipliesBands) {
  const Vec3d axis = normalize({-0.4, 0.2, 0.6});
  const std::vector<double> phong = phongLobeFactors(9, 5.5), ones(10, 1.0);
  std::vector<double> light(100), expected(100);
  zonalCoefficients(axis, ones, light);
  zonalCoefficients(axis, phong, expected);
  convolve(light, phong);
  for (std::size_t i = 0; i < light.size(); ++i) EXPECT_DOUBLE_EQ(light[i], expected[i]) << i;
  // Convolving with g1, then g2, is convolving with g1 g2.
  convolve(light, henyeyGreensteinFactors(9, 0.5));
  convolve(light, henyeyGreensteinFactors(9, 0.8));
  convolve(expected, henyeyGreensteinFactors(9, 0.4));
  for (std::size_t i = 0; i < light.size(); ++i) EXPECT_NEAR(light[i], expected[i], 1e-15) << i;
}

TEST(ZonalFactors, RefusesParametersOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double s : {-0.1, nan, inf}) {
    EXPECT_THROW(phongLobeFactors(3, s), Error) << s;
    EXPECT_THROW(powerLobeFactors(3, s), Error) << s;
  }
  for (const double g : {1.0, -1.0, 2.0, nan}) EXPECT_THROW(henyeyGreensteinFactors(3, g), Error) << g;
}

}  // namespace
}  // namespace shprt
