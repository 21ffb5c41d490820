// Warps against their densities, and the lattice against integrals known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "disc_integrands.h"
#include "shprt/sampling/fibonacci_hemisphere.h"
#include "shprt/sampling/hemisphere.h"
#include "shprt/sampling/random.h"

namespace shprt {
namespace {

TEST(Random, IsUniformAndDiffersBySeedIndexAndDimension) {
  double sum = 0, squares = 0;
  const int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double u = uniformRandom(7, static_cast<std::uint64_t>(i), 0);
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
    squares += u * u;
  }
  // Five standard errors of the mean and of the mean square of a uniform number.
  EXPECT_NEAR(sum / count, 0.5, 5 * std::sqrt(1.0 / 12 / count));
  EXPECT_NEAR(squares / count, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / count));
  EXPECT_NE(uniformRandom(7, 1, 0), uniformRandom(8, 1, 0));
  EXPECT_NE(uniformRandom(7, 1, 0), uniformRandom(7, 2, 0));
  EXPECT_NE(uniformRandom(7, 1, 0), uniformRandom(7, 1, 1));
  static_assert(uniformRandom(1, 2, 3) == uniformRandom(1, 2, 3));
}

TEST(CosineHemisphere, DensityIntegratesToOneAndMatchesTheWarp) {
  // The mean of 1/pdf over samples is the solid angle of the hemisphere; the mean of cos is 2/3.
  double area = 0, cosine = 0;
  const int side = 400;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const Vec3d d = sampleCosineHemisphere((i + 0.5) / side, (j + 0.5) / side);
      ASSERT_NEAR(length(d), 1, 1e-14);
      area += 1 / pdfCosineHemisphere(d);
      cosine += d.z;
    }
  EXPECT_NEAR(area / (side * side), 2 * std::numbers::pi, 0.1);  // integrable singularity at the horizon
  EXPECT_NEAR(cosine / (side * side), 2.0 / 3, 1e-4);
  EXPECT_EQ(pdfCosineHemisphere({0, 0, -1}), 0);
  EXPECT_DOUBLE_EQ(pdfCosineHemisphere({0, 0, 1}), 1 / std::numbers::pi);
}

TEST(CosineHemisphere, DirectionsAroundANormalStayAboveTheHorizon) {
  for (const Vec3d normal : {Vec3d{0, 0, 1}, Vec3d{0, 0, -1}, normalize({1, -2, 3}), normalize({-5, 3, -1})})
    for (int turn = 0; turn < 100; ++turn) {
      const Vec3d direction = toDouble(cosineDirectionAround(frameFromNormal(normal), 1, turn / 100.0));
      EXPECT_NEAR(length(direction), 1, 4e-7);
      EXPECT_GT(dot(direction, normal), 0);
    }
}

struct Directions {
  std::vector<float> x, y, z;
};

Directions latticeDirections(const FibonacciHemisphere& lattice, Vec3d normal, std::uint64_t seed,
                             std::uint64_t index) {
  Directions d{std::vector<float>(lattice.paddedCount()), std::vector<float>(lattice.paddedCount()),
               std::vector<float>(lattice.paddedCount())};
  lattice.directions(normal, seed, index, d.x.data(), d.y.data(), d.z.data());
  return d;
}

TEST(FibonacciHemisphere, DirectionsAreUnitAndAboveTheHorizonForAnyCount) {
  for (const int count : {1, 2, 15, 16, 17, 255, 256, 1000}) {
    const FibonacciHemisphere lattice(count, 16);
    EXPECT_EQ(lattice.paddedCount() % 16, 0u);
    EXPECT_GE(lattice.paddedCount(), static_cast<std::size_t>(count));
    for (const Vec3d normal : {Vec3d{0, 0, 1}, Vec3d{0, 0, -1}, normalize({1, -2, 3}), Vec3d{0, -1, 0}}) {
      const Directions d = latticeDirections(lattice, normal, 3, 5);
      for (std::size_t i = 0; i < d.x.size(); ++i) {
        const Vec3d w{d.x[i], d.y[i], d.z[i]};
        ASSERT_NEAR(length(w), 1, 4e-7);
        ASSERT_GT(dot(w, normal), 0);
      }
    }
  }
}

// Means of cos^k over the cosine distribution are 2/(k+2); a lattice of n points reaches them far closer than
// random points would (1/sqrt(n)), and their mean over shifts is unbiased.
TEST(FibonacciHemisphere, IntegratesPowersOfTheCosine) {
  const int count = 256;
  const FibonacciHemisphere lattice(count, 16);
  const Vec3d normal = normalize({0.3, 0.8, -0.5});
  for (const int power : {1, 2, 5}) {
    double overShifts = 0;
    for (std::uint64_t index = 0; index < 200; ++index) {
      const Directions d = latticeDirections(lattice, normal, 1, index);
      double mean = 0;
      for (std::size_t i = 0; i < count; ++i)
        mean += std::pow(dot(Vec3d{d.x[i], d.y[i], d.z[i]}, normal), power);
      mean /= count;
      EXPECT_NEAR(mean, 2.0 / (power + 2), 0.01);
      overShifts += mean / 200;
    }
    EXPECT_NEAR(overShifts, 2.0 / (power + 2), 3e-4);
  }
}

// A half space cut by a plane through the axis holds half the points, whatever the azimuth.
TEST(FibonacciHemisphere, IsEvenInAzimuth) {
  const FibonacciHemisphere lattice(256, 16);
  for (std::uint64_t index = 0; index < 50; ++index) {
    const Directions d = latticeDirections(lattice, {0, 0, 1}, 9, index);
    int right = 0;
    for (std::size_t i = 0; i < 256; ++i) right += d.x[i] > 0;
    EXPECT_NEAR(right, 128, 6);
  }
}

// Of all lattices, the hexagonal one has the least error for figures at random: with one point per area A,
// the variance of (a count times A), averaged over directions and for a large figure of perimeter L, is L /
// (4 pi^3) A^(3/2) E, where E is the sum of |k|^-3 over the dual lattice at unit covolume, since the square
// of a figure's Fourier transform falls as L / (4 pi^3 |k|^3), as a disc's does. Hexagonal E is 6 zeta(3/2)
// L(3/2) (sqrt(3)/2)^(3/2) = 8.8927, with the L function of the character modulo 3. On the unit disc A is pi
// / n, and a mean is a count times A / pi. The edge of the unit disc is none of the figure's. The spiral of
// directions, locally a lattice of changing shape, comes near it: only other estimators, not other points,
// have much to gain.
TEST(FibonacciHemisphere, ErrsLittleMoreThanTheBestOfLattices) {
  constexpr int kCount = 512;
  constexpr double kPi = std::numbers::pi, kHexagonal = 8.8927;
  const FibonacciHemisphere lattice(kCount, 16);
  double errors = 0, perimeters = 0;
  for (std::uint64_t index = 0; index < 4000; ++index) {
    const double distance = 0.9 * uniformRandom(1, index, 0);
    const test::DiscIntegrand figure = test::halfPlane(0, distance);
    errors += std::pow(test::meanOver(test::directionsOf(lattice, 2, index), figure) - figure.mean, 2);
    perimeters += 2 * std::sqrt(1 - distance * distance);
  }
  const double best =
      perimeters / (4 * std::pow(kPi, 3)) * std::pow(kPi / kCount, 1.5) * kHexagonal / (kPi * kPi);
  EXPECT_GT(std::sqrt(errors / best), 0.95);  // 4000 draws are known to about 1.5%
  EXPECT_LT(std::sqrt(errors / best), 1.15);
}

// A quarter is the lattice stretched by two, so it errs like a lattice of a quarter of the points; every
// fourth ring would be half as bad again.
TEST(FibonacciHemisphere, QuartersAreAsGoodAsLatticesOfTheirSize) {
  const FibonacciHemisphere lattice(64, 16), small(16, 16);
  double quarterErrors = 0, smallErrors = 0;
  for (std::uint64_t index = 0; index < 3000; ++index) {
    const test::DiscIntegrand figure = test::halfPlane(0, 0.9 * uniformRandom(1, index, 0));
    const std::vector<Vec3d> directions = test::directionsOf(lattice, 2, index);
    double sums[4] = {};
    for (std::size_t i = 0; i < directions.size(); ++i)
      sums[lattice.quarters()[i]] += figure.value(directions[i]);
    for (const double sum : sums) quarterErrors += std::pow(sum / 16 - figure.mean, 2) / 4;
    smallErrors += std::pow(test::meanOver(test::directionsOf(small, 3, index), figure) - figure.mean, 2);
  }
  EXPECT_LT(std::sqrt(quarterErrors / smallErrors), 1.25);
}

TEST(FibonacciHemisphere, SeedAndIndexFixEverything) {
  const FibonacciHemisphere lattice(64, 16);
  const Vec3d normal = normalize({1, 1, 1});
  EXPECT_EQ(latticeDirections(lattice, normal, 4, 2).x, latticeDirections(lattice, normal, 4, 2).x);
  EXPECT_NE(latticeDirections(lattice, normal, 4, 2).x, latticeDirections(lattice, normal, 5, 2).x);
  EXPECT_NE(latticeDirections(lattice, normal, 4, 2).x, latticeDirections(lattice, normal, 4, 3).x);
}

}  // namespace
}  // namespace shprt
