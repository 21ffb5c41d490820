// Spherical harmonics against 50-digit values, orthonormality, and the addition theorem.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shprt/sh/accumulate.h"
#include "shprt/sh/accumulate_variants.h"
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

Vec3d readDirection(const nlohmann::json& entry) {
  // The reference belongs to xyz/|xyz|; a binary32 direction is off unit length by 1e-8.
  return normalize({entry["xyz"][0], entry["xyz"][1], entry["xyz"][2]});
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
      ASSERT_NEAR(y[i], entry["values"][i].get<double>(), 1e-13 * bandScale(bandOf(static_cast<int>(i))))
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
                  (l <= 100 ? 3e-13 : 2e-11) * bandScale(l))
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
        Vec3d{0.01, 0, 1}, Vec3d{0.1, 0.2, 0.9}, Vec3d{-0.6, 0.7, 0.01}}) {
    const std::vector<double> y = evaluate(2500, normalize(direction));
    for (const int l : {0, 1, 50, 86, 187, 1000, 1478, 2500}) {
      double sum = 0;
      for (int m = -l; m <= l; ++m)
        sum += y[static_cast<std::size_t>(shIndex(l, m))] * y[static_cast<std::size_t>(shIndex(l, m))];
      EXPECT_NEAR(sum / (bandScale(l) * bandScale(l)), 1, 1e-10)
          << "degree " << l << " at " << direction.x << " " << direction.z;
    }
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

struct Directions {
  std::vector<float> x, y, z, weight;
};

// Directions over the sphere, poles and their neighbourhood among them, with weights of both signs.
Directions manyDirections(std::size_t count) {
  Directions d;
  for (std::size_t k = 0; k < count; ++k) {
    const double turns = std::fmod(0.618034 * double(k), 1.0), angle = 2 * std::numbers::pi * turns;
    double z = 1 - (2 * double(k) + 1) / double(count);
    if (k % 7 == 3) z = std::copysign(std::cos(1e-3 * double(k)), z);
    if (k % 64 == 0) z = k % 128 ? 1 : -1;
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    d.x.push_back(float(r * std::cos(angle)));
    d.y.push_back(float(r * std::sin(angle)));
    d.z.push_back(float(z));
    d.weight.push_back(float(std::cos(3.7 * double(k))));
  }
  return d;
}

TEST(Accumulate, AgreesWithTheReferenceFunctionInEveryVariant) {
  for (const AccumulateVariant& variant :
       {AccumulateVariant{"baseline", accumulateShBaseline}, chooseAccumulateVariant()})
    for (const int degree : {0, 1, 2, 3, 4, 5, 8, 15, 32})
      for (const std::size_t count : {16u, 272u, 1024u}) {
        const Directions d = manyDirections(count);
        std::vector<double> sums(static_cast<std::size_t>(coefficientCount(degree)), 1e9),
            expected(sums.size()), y(sums.size());
        variant.function(degree, d.x.data(), d.y.data(), d.z.data(), d.weight.data(), count, sums.data());
        double weights = 0;
        for (std::size_t k = 0; k < count; ++k) {
          evaluateSh(degree, normalize({d.x[k], d.y[k], d.z[k]}), y);
          weights += std::abs(double(d.weight[k]));
          for (std::size_t i = 0; i < y.size(); ++i) expected[i] += double(d.weight[k]) * y[i];
        }
        for (std::size_t i = 0; i < y.size(); ++i) {
          const int l = bandOf(static_cast<int>(i));
          ASSERT_NEAR(sums[i], expected[i], weights * (1e-6 + 4e-8 * l * l) * bandScale(l))
              << variant.name << " degree " << degree << " " << i;
        }
      }
}

TEST(Accumulate, EachValueHasTheAccuracyItStates) {
  const Directions d = manyDirections(1024);
  for (const int degree : {4, 8, 32}) {
    std::vector<double> sums(static_cast<std::size_t>(coefficientCount(degree))), y(sums.size());
    for (std::size_t k = 0; k < 1024; ++k) {
      float x[16] = {}, dy[16] = {}, z[16], weight[16] = {};
      std::fill(z, z + 16, 1.0f);
      x[5] = d.x[k], dy[5] = d.y[k], z[5] = d.z[k], weight[5] = 1;
      accumulateSh(degree, x, dy, z, weight, 16, sums.data());
      evaluateSh(degree, normalize({d.x[k], d.y[k], d.z[k]}), y);
      for (std::size_t i = 0; i < y.size(); ++i) {
        const int l = bandOf(static_cast<int>(i));
        ASSERT_NEAR(sums[i], y[i], (1e-6 + 4e-8 * l * l) * bandScale(l))
            << "degree " << degree << ", direction " << k << ", " << i;
      }
    }
  }
}

}  // namespace
}  // namespace shprt
