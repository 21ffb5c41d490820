// The float kernels, in every variant the processor has, against the reference function evaluateSh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shprt/sh/accumulate.h"
#include "shprt/sh/accumulate_variants.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/evaluate_batch.h"
#include "shprt/sh/evaluate_batch_variants.h"

namespace shprt {
namespace {

// What both kernels promise of a value of band l, for a batch of that degree.
double promisedError(int degree, int l) {
  return (degree <= 8 ? 5e-7 : 2e-6) * std::sqrt((2 * l + 1) / (4 * std::numbers::pi));
}

struct Directions {
  std::vector<float> x, y, z, weight;

  void add(double sine, double cosine, double angle) {
    weight.push_back(float(std::cos(3.7 * double(x.size()))));
    x.push_back(float(sine * std::cos(angle)));
    y.push_back(float(sine * std::sin(angle)));
    z.push_back(float(cosine));
  }
  std::size_t count() const { return x.size(); }
};

// Directions over the sphere, the axes, and the neighbourhood of both poles down to 1e-30 rad.
Directions manyDirections(std::size_t count) {
  Directions d;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * std::fmod(0.618034 * double(k), 1.0), pole = k % 2 ? 1 : -1;
    if (k % 3 == 1) {
      const double tilt = std::pow(
          10.0, -30 * double(k) / double(count) * (k % 5 == 0) - 3 * std::fmod(0.7548777 * double(k), 1.0));
      d.add(std::sin(tilt), pole * std::cos(tilt), angle);
    } else if (k % 64 == 0) {
      d.add(0, pole, 0);
    } else if (k % 64 == 2) {
      d.add(1, 0, double(k / 64) * std::numbers::pi / 2);
    } else {
      const double z = 1 - (2 * double(k) + 1) / double(count);
      d.add(std::sqrt(1 - z * z), z, angle);
    }
  }
  return d;
}

TEST(EvaluateBatch, AgreesWithTheReferenceFunctionInEveryVariant) {
  const Directions d = manyDirections(6000);
  for (int degree = 0; degree <= 32; degree += degree < 10 ? 1 : 11) {
    const std::size_t coefficients = static_cast<std::size_t>(coefficientCount(degree));
    std::vector<float> results(coefficients * d.count());
    std::vector<double> y(coefficients);
    for (const EvaluateBatchVariant& variant : evaluateBatchVariants()) {
      variant.function(degree, d.x.data(), d.y.data(), d.z.data(), d.count(), results.data(), d.count());
      for (std::size_t k = 0; k < d.count(); ++k) {
        evaluateSh(degree, {d.x[k], d.y[k], d.z[k]}, y);
        for (std::size_t i = 0; i < coefficients; ++i) {
          ASSERT_NEAR(results[i * d.count() + k], y[i], promisedError(degree, bandOf(static_cast<int>(i))))
              << variant.name << ", degree " << degree << ", " << i << " at " << d.x[k] << " " << d.y[k]
              << " " << d.z[k];
        }
      }
    }
  }
}

// A direction's values do not depend on its place and on the count but for rounding, and what lies between
// and behind the rows stays. The inputs end where their allocation ends, so that a sanitizer sees a read past
// them.
TEST(EvaluateBatch, TakesAnyCountAndTouchesNothingElse) {
  const Directions all = manyDirections(300);
  constexpr float kUntouched = -7.5f;
  for (const EvaluateBatchVariant& variant : evaluateBatchVariants())
    for (const int degree : {0, 1, 3, 4, 8, 13}) {
      const std::size_t coefficients = static_cast<std::size_t>(coefficientCount(degree));
      std::vector<float> expected(coefficients * 300);
      variant.function(degree, all.x.data(), all.y.data(), all.z.data(), 300, expected.data(), 300);
      for (std::size_t count = 0; count <= 150; count += count < 40 ? 1 : 11) {
        const std::ptrdiff_t end = static_cast<std::ptrdiff_t>(count);
        const std::vector<float> x(all.x.begin(), all.x.begin() + end), y(all.y.begin(), all.y.begin() + end),
            z(all.z.begin(), all.z.begin() + end);
        const std::size_t stride = count + 3;
        std::vector<float> results(coefficients * stride, kUntouched);
        variant.function(degree, x.data(), y.data(), z.data(), count, results.data(), stride);
        for (std::size_t i = 0; i < coefficients; ++i)
          for (std::size_t k = 0; k < stride; ++k) {
            if (k < count) {
              ASSERT_NEAR(results[i * stride + k], expected[i * 300 + k],
                          promisedError(degree, bandOf(static_cast<int>(i))))
                  << variant.name << ", degree " << degree << ", count " << count << ", " << i << " of " << k;
            } else {
              ASSERT_EQ(results[i * stride + k], kUntouched)
                  << variant.name << ", degree " << degree << ", count " << count << ", " << i << " of " << k;
            }
          }
      }
    }
}

// Powers of a small sine underflow in float; they must not do so by way of subnormal numbers.
TEST(EvaluateBatch, HasNoSubnormalValues) {
  Directions d;
  for (int k = 0; k < 400; ++k) d.add(std::pow(10.0, -0.1 * k), k % 2 ? 1 : -1, k);
  std::vector<float> results(static_cast<std::size_t>(coefficientCount(32)) * d.count());
  for (const EvaluateBatchVariant& variant : evaluateBatchVariants())
    for (const int degree : {1, 2, 4, 8, 32}) {
      variant.function(degree, d.x.data(), d.y.data(), d.z.data(), d.count(), results.data(), d.count());
      for (std::size_t i = 0; i < static_cast<std::size_t>(coefficientCount(degree)) * d.count(); ++i)
        ASSERT_TRUE(results[i] == 0 || std::isnormal(results[i]))
            << variant.name << " " << i << " " << results[i];
    }
}

TEST(EvaluateBatch, ChoosesAVariant) {
  const float x = 0.6f, y = 0, z = -0.8f;
  float results[4];
  evaluateShBatch(1, &x, &y, &z, 1, results, 1);
  const float c = float(std::sqrt(3 / (4 * std::numbers::pi)));
  EXPECT_NEAR(results[2], -0.8f * c, 1e-7);
  EXPECT_NEAR(results[3], 0.6f * c, 1e-7);
}

TEST(Accumulate, AgreesWithTheReferenceFunctionInEveryVariant) {
  for (const AccumulateVariant& variant : accumulateVariants())
    for (const int degree : {0, 1, 2, 3, 4, 5, 8, 15, 32})
      for (const std::size_t count : {16u, 272u, 1024u}) {
        const Directions d = manyDirections(count);
        std::vector<double> sums(static_cast<std::size_t>(coefficientCount(degree)), 1e9),
            expected(sums.size()), y(sums.size());
        variant.function(degree, d.x.data(), d.y.data(), d.z.data(), d.weight.data(), count, sums.data());
        double weights = 0;
        for (std::size_t k = 0; k < count; ++k) {
          evaluateSh(degree, {d.x[k], d.y[k], d.z[k]}, y);
          weights += std::abs(double(d.weight[k]));
          for (std::size_t i = 0; i < y.size(); ++i) expected[i] += double(d.weight[k]) * y[i];
        }
        for (std::size_t i = 0; i < y.size(); ++i) {
          ASSERT_NEAR(sums[i], expected[i], weights * promisedError(degree, bandOf(static_cast<int>(i))))
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
      evaluateSh(degree, {d.x[k], d.y[k], d.z[k]}, y);
      for (std::size_t i = 0; i < y.size(); ++i) {
        ASSERT_NEAR(sums[i], y[i], promisedError(degree, bandOf(static_cast<int>(i))))
            << "degree " << degree << ", direction " << k << ", " << i;
      }
    }
  }
}

}  // namespace
}  // namespace shprt
