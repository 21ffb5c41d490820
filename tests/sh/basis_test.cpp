// Spherical harmonics against 50-digit values, orthonormality, and the addition theorem.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shprt/sh/basis.h"
#include "shprt/sh/zonal.h"
#include "tests/sh/reference.h"

namespace shprt {
namespace {

double bandScale(int l) {
  return std::sqrt((2 * l + 1) / (4 * std::numbers::pi));
}

std::vector<double> evaluate(int degree, Vec3d direction) {
  std::vector<double> y(static_cast<std::size_t>(coefficientCount(degree)));
  evaluateSh(degree, direction, y);
  return y;
}

// The reference belongs to xyz/|xyz|, as what evaluateSh returns does: of "single" directions too, whose
// length is off by 1e-8.
Vec3d readDirection(const nlohmann::json& entry) {
  return {entry["xyz"][0], entry["xyz"][1], entry["xyz"][2]};
}

TEST(Basis, HasTheConventionOfTheProject) {
  const double c = std::sqrt(3 / (4 * std::numbers::pi));
  const Vec3d d = normalize({0.3, -0.5, 0.7});
  const std::vector<double> y = evaluate(1, d);
  EXPECT_NEAR(y[0], std::sqrt(1 / (4 * std::numbers::pi)), 1e-16);
  EXPECT_NEAR(y[1], c * d.y, 1e-15);
  EXPECT_NEAR(y[2], c * d.z, 1e-15);
  EXPECT_NEAR(y[3], c * d.x, 1e-15);
  static_assert(shIndex(3, -2) == 10 && coefficientCount(4) == 25 && bandOf(10) == 3 && bandOf(9) == 3 &&
                bandOf(8) == 2);
}

TEST(Basis, AgreesWithTheReferenceToDegree20) {
  SHPRT_NEEDS_REFERENCE();
  const auto reference = test::readReference("sh_eval.json");
  ASSERT_GT(reference["directions"].size(), 10u);
  for (const auto& entry : reference["directions"]) {
    const std::vector<double> y = evaluate(20, readDirection(entry));
    for (std::size_t i = 0; i < y.size(); ++i) {
      ASSERT_NEAR(y[i], entry["values"][i].get<double>(), 4e-15 * bandScale(bandOf(static_cast<int>(i))))
          << entry["name"] << " " << i;
    }
  }
}

TEST(Basis, AgreesWithTheReferenceToDegree1000) {
  SHPRT_NEEDS_REFERENCE();
  const auto reference = test::readReference("sh_eval.json");
  int samples = 0;
  for (const auto& entry : reference["high_degree"]) {
    const std::vector<double> y = evaluate(1000, readDirection(entry));
    for (const auto& sample : entry["samples"]) {
      const int l = sample[0], m = sample[1];
      ASSERT_NEAR(y[static_cast<std::size_t>(shIndex(l, m))], sample[2].get<double>(),
                  (l <= 100 ? 1e-14 : 3e-14) * bandScale(l))
          << entry["name"] << " " << l << " " << m;
      ++samples;
    }
  }
  EXPECT_GT(samples, 100);
}

// The sum of squares of a band is (2l+1)/(4 pi) in every direction, far beyond the degree where unscaled
// recurrences end.
TEST(Basis, FulfilsTheAdditionTheoremToDegree2500) {
  for (const Vec3d direction :
       {Vec3d{0, 0, 1}, Vec3d{0, 0, -1}, Vec3d{1, 0, 0}, Vec3d{1e-20, 0, 1}, Vec3d{1e-8, 1e-9, -1},
        Vec3d{1e-200, 1e-310, 1}, Vec3d{0.01, 0, 1}, Vec3d{0.1, 0.2, 0.9}, Vec3d{-0.6, 0.7, 0.01}}) {
    const std::vector<double> y = evaluate(2500, normalize(direction));
    for (const int l : {0, 1, 50, 86, 187, 1000, 1478, 2500}) {
      double sum = 0;
      for (int m = -l; m <= l; ++m)
        sum += y[static_cast<std::size_t>(shIndex(l, m))] * y[static_cast<std::size_t>(shIndex(l, m))];
      EXPECT_NEAR(sum / (bandScale(l) * bandScale(l)), 1, 1e-12)
          << "degree " << l << " at " << direction.x << " " << direction.z;
    }
  }
}

// y_l0 = sqrt((2l+1)/4pi) P_l(cos theta), and beside a pole P_l is a series in t = 1 - cos theta whose terms
// are known: sum over k of (-1)^k (l+k)! / ((l-k)! k!^2) (t/2)^k.
TEST(Basis, ZonalValuesFollowTheLegendreSeriesAtAnyDistanceToThePole) {
  const int degree = 1000;
  for (const double tilt : {1e-20, 1e-16, 1e-12, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 5e-4, 1e-3})
    for (const double pole : {1.0, -1.0}) {
      const std::vector<double> y =
          evaluate(degree, {0.6 * std::sin(tilt), 0.8 * std::sin(tilt), pole * std::cos(tilt)});
      const long double half = std::sin(tilt / 2.0L) * std::sin(tilt / 2.0L);
      for (const int l : {1, 2, 7, 50, 100, 333, 1000}) {
        long double term = 1, sum = 1;
        for (int k = 1; k <= l; ++k) {
          term *= -half * (l + k) * (l - k + 1) / (static_cast<long double>(k) * k);
          sum += term;
        }
        const double expected = bandScale(l) * static_cast<double>(pole < 0 && l % 2 ? -sum : sum);
        ASSERT_NEAR(y[static_cast<std::size_t>(shIndex(l, 0))], expected,
                    (l <= 100 ? 1e-14 : 3e-14) * bandScale(l))
            << "l " << l << ", tilt " << tilt << ", pole " << pole;
      }
    }
}

// y_mm is sqrt((2m+1)!! / (2m)!! / 2pi) cos m phi sin^m theta.
TEST(Basis, SectoralValuesOfTheEquatorFollowTheirClosedForm) {
  const int degree = 1000;
  const long double phi = 0.7L;
  const std::vector<double> y =
      evaluate(degree, {static_cast<double>(std::cos(phi)), static_cast<double>(std::sin(phi)), 0});
  long double squared = 1 / (2 * std::numbers::pi_v<long double>);
  for (int m = 1; m <= degree; ++m) {
    squared *= (2 * m + 1.0L) / (2 * m);
    // Rounding the direction turns it by 1e-16.
    const double tolerance = (1e-14 + 2e-16 * m) * bandScale(m);
    ASSERT_NEAR(y[static_cast<std::size_t>(shIndex(m, m))], std::sqrt(squared) * std::cos(m * phi), tolerance)
        << m;
    ASSERT_NEAR(y[static_cast<std::size_t>(shIndex(m, -m))], std::sqrt(squared) * std::sin(m * phi),
                tolerance)
        << m;
  }
}

// Not-a-number would compare as unequal to everything, so each value is looked at.
TEST(Basis, HasNoSubnormalNorInfiniteValuesAtAnyDegree) {
  const int degree = 3000;
  std::vector<double> y(static_cast<std::size_t>(coefficientCount(degree)));
  for (const Vec3d direction : {Vec3d{0, 0, -1}, Vec3d{1e-20, 1e-21, 1}, Vec3d{1e-7, 1e-300, -1},
                                Vec3d{0.05, 0.01, 1}, Vec3d{0.3, -0.5, 0.7}, Vec3d{0, 1, 1e-18}}) {
    evaluateSh(degree, normalize(direction), y);
    for (std::size_t i = 0; i < y.size(); ++i) {
      ASSERT_TRUE(y[i] == 0 || std::isnormal(y[i]))
          << i << " at " << direction.x << " " << direction.z << ": " << y[i];
    }
  }
}

TEST(Basis, TakesDirectionsThatAreOffUnitLength) {
  const Vec3d unit = normalize({0.3, -0.5, 0.7});
  const std::vector<double> expected = evaluate(200, unit);
  for (const double length : {1 + 1e-15, 1 - 6e-8, 1 + 6e-8, 1.01, 3.0}) {
    const std::vector<double> y = evaluate(200, unit * length);
    for (std::size_t i = 0; i < y.size(); ++i)
      ASSERT_NEAR(y[i], expected[i], 1e-13 * bandScale(bandOf(static_cast<int>(i))))
          << i << ", length " << length;
  }
}

// Midpoints in azimuth and Gauss nodes in z would be exact; a fine product rule in z is close enough to show
// any error.
TEST(Basis, IsOrthonormal) {
  const int degree = 6, count = coefficientCount(degree), rows = 4000, columns = 32;
  std::vector<double> gram(static_cast<std::size_t>(count * count));
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double z = -1 + (2 * i + 1.0) / rows, phi = 2 * std::numbers::pi * (j + 0.5) / columns,
                   r = std::sqrt(1 - z * z);
      const std::vector<double> y = evaluate(degree, {r * std::cos(phi), r * std::sin(phi), z});
      for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b) {
          gram[static_cast<std::size_t>(a * count + b)] += y[static_cast<std::size_t>(a)] *
                                                           y[static_cast<std::size_t>(b)] * 4 *
                                                           std::numbers::pi / (rows * columns);
        }
    }
  for (int a = 0; a < count; ++a)
    for (int b = 0; b < count; ++b)
      EXPECT_NEAR(gram[static_cast<std::size_t>(a * count + b)], a == b, 2e-5) << a << " " << b;
}

TEST(Zonal, ClampedCosineAgreesWithTheReference) {
  SHPRT_NEEDS_REFERENCE();
  const auto reference = test::readReference("zonal.json")["clamped_cosine"]["A"];
  const std::vector<double> factors = clampedCosineFactors(100);
  for (std::size_t l = 0; l <= 100; ++l)
    EXPECT_NEAR(factors[l], reference[l].get<double>(), 4e-16 * std::abs(factors[l]) + 1e-18) << l;
}

TEST(Zonal, ClampedCosineStartsAsInThePaper) {
  const std::vector<double> factors = clampedCosineFactors(4);
  EXPECT_DOUBLE_EQ(factors[0], std::numbers::pi);
  EXPECT_DOUBLE_EQ(factors[1], 2 * std::numbers::pi / 3);
  EXPECT_DOUBLE_EQ(factors[2], std::numbers::pi / 4);
  EXPECT_EQ(factors[3], 0);
  EXPECT_DOUBLE_EQ(factors[4], -std::numbers::pi / 24);
  EXPECT_EQ(clampedCosineFactors(0).size(), 1u);
}

}  // namespace
}  // namespace shprt
