// Error and orthogonality defect of Wigner matrices at high bands and hard rotations, against Risbo's
// recursion in extended precision, and what other recurrences reach.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"
#include "shprt/sh/rotation_swap.h"
#include "tests/sh/peer_rotation.h"

namespace shprt {
namespace {

struct NamedRotation {
  const char* name;
  Mat3 matrix;
};

std::vector<NamedRotation> hardRotations() {
  std::vector<NamedRotation> rotations;
  for (const char* text : {"axis:1,2,3,0", "axis:1,0,0,180", "axis:0,1,0,180", "axis:0,0,1,180",
                           "axis:0,0,1,37", "axis:1,1,0,180", "axis:1,1,1,120", "axis:1,0,0,90",
                           "axis:0,1,0,90", "euler:zyz,20,180,30", "axis:-1,2,0.5,77"})
    rotations.push_back({text, parseRotation(text)});
  for (const double beta : {1e-12, 1e-8, 0.1, 3.0, std::numbers::pi - 1e-12})
    rotations.push_back({"tilted", rotationFromEulerZyz(0.3, beta, 1.1)});
  rotations.push_back({"tilted alone", rotationFromEulerZyz(0.3, 1e-12, -0.3)});
  return rotations;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

double orthogonalityDefect(const std::vector<double>& matrix, std::size_t size) {
  double largest = 0;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = i; j < size; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < size; ++k) sum += matrix[i * size + k] * matrix[j * size + k];
      largest = std::max(largest, std::abs(sum - (i == j ? 1.0 : 0.0)));
    }
  return largest;
}

constexpr bool kHaveExtendedPrecision = std::numeric_limits<long double>::digits > 60;

TEST(RotationPrecision, ErrorIsWithinTheBoundAtHardRotations) {
  if (!kHaveExtendedPrecision) GTEST_SKIP() << "SKIPPED: long double is no more precise than double here";
  for (const auto& [name, matrix] : hardRotations())
    for (const auto& [l, bound] :
         {std::pair{1, 1e-15}, {2, 2e-15}, {6, 4e-15}, {7, 4e-15}, {8, 4e-15}, {20, 1e-14}, {50, 2e-14}})
      EXPECT_LE(largestDifference(wignerMatrix(l, matrix), test::referenceWigner(l, matrix)), bound)
          << name << " " << l;
}

TEST(RotationPrecision, ErrorIsWithinTheBoundAtBand200) {
  if (!kHaveExtendedPrecision) GTEST_SKIP() << "SKIPPED: long double is no more precise than double here";
  for (const Mat3& matrix : {parseRotation("axis:-1,2,0.5,77"), rotationFromEulerZyz(0.3, 0.1, 1.1)})
    EXPECT_LE(largestDifference(wignerMatrix(200, matrix), test::referenceWigner(200, matrix)), 5e-14);
}

TEST(RotationPrecision, MatricesStayOrthogonal) {
  for (const auto& [name, matrix] : hardRotations()) {
    EXPECT_LE(orthogonalityDefect(wignerMatrix(7, matrix), 15), 6e-15) << name;
    EXPECT_LE(orthogonalityDefect(wignerMatrix(50, matrix), 101), 2e-14) << name;
  }
  for (const Mat3& matrix : {parseRotation("axis:1,0,0,180"), rotationFromEulerZyz(0.3, 3, 1.1)})
    EXPECT_LE(orthogonalityDefect(wignerMatrix(200, matrix), 401), 5e-14);
}

// The rotated zonal vector is the basis in the direction where the pole went.
TEST(RotationPrecision, TurnsThePoleToDegree400) {
  const int degree = 400;
  const Mat3 rotation = rotationFromEulerZyz(0.4, 1.2, -2.0);
  std::vector<double> set(static_cast<std::size_t>(coefficientCount(degree))), expected(set.size());
  evaluateSh(degree, {0, 0, 1}, set);
  evaluateSh(degree, rotation * Vec3d{0, 0, 1}, expected);
  ShRotation(degree, rotation).apply(set);
  for (std::size_t i = 0; i < set.size(); ++i) ASSERT_NEAR(set[i], expected[i], 1e-12) << i;
}

// The exchange of y and z undoes itself: blocks are symmetric, or transposes, and their squares are 1.
TEST(RotationSwap, IsItsOwnInverse) {
  for (const int l : {0, 1, 2, 3, 4, 5, 16, 63, 128, 501, 1000, 1999}) {
    SwapBand swap;
    buildSwapBand(l, swap);
    const double bound = l <= 1000 ? 2e-14 : 5e-14;
    std::vector<double> cosines, sines;
    for (int i = 0; i < swap.even; ++i) cosines.push_back(std::sin(3.1 * i + 1));
    for (int i = 0; i < swap.even; ++i) sines.push_back(l % 2 == 0 && i == 0 ? 0 : std::cos(2.3 * i));
    const auto product = [](const double* block, int rows, int stride, const std::vector<double>& from) {
      std::vector<double> to(static_cast<std::size_t>(rows));
      for (std::size_t k = 0; k < from.size(); ++k)
        for (std::size_t i = 0; i < to.size(); ++i)
          to[i] += block[k * static_cast<std::size_t>(stride) + i] * from[k];
      return to;
    };
    const auto square = product(swap.evenCosines, swap.even, swap.evenStride,
                                product(swap.evenCosines, swap.even, swap.evenStride, cosines));
    EXPECT_LE(largestDifference(square, cosines), bound) << l;
    const auto back = product(swap.evenSines, swap.even, swap.evenStride,
                              product(swap.oddCosines, swap.odd, swap.oddStride, sines));
    EXPECT_LE(largestDifference(back, sines), bound) << l;
  }
}

TEST(PeerRotation, OtherMethodsAgreeAtLowBandsAndNotAtHighOnes) {
  for (const double beta : {0.1, 1.0, 3.0}) {
    const Mat3 matrix = rotationFromEulerZyz(0, beta, 0);
    for (int l = 1; l <= 6; ++l) {
      const std::vector<double> ours = wignerMatrix(l, matrix);
      EXPECT_LE(largestDifference(test::ivanicRuedenbergWigner(l, matrix), ours), 1e-13) << l;
      EXPECT_LE(largestDifference(test::realRecurrenceTurnAboutY(l, beta), ours), 1e-11) << l;
    }
  }
  const Mat3 general = parseRotation("axis:-1,2,0.5,77");
  EXPECT_LE(largestDifference(test::ivanicRuedenbergWigner(4, general), wignerMatrix(4, general)), 1e-14);
  if (!kHaveExtendedPrecision) GTEST_SKIP() << "SKIPPED: long double is no more precise than double here";
  // Each where it is weak: the one away from the axes, the other at small tilts.
  const std::vector<double> generalReference = test::referenceWigner(80, general);
  const double generalError = largestDifference(wignerMatrix(80, general), generalReference);
  EXPECT_LE(generalError, 3e-14);
  EXPECT_GE(largestDifference(test::ivanicRuedenbergWigner(80, general), generalReference),
            1e3 * generalError);
  const Mat3 tilted = rotationFromEulerZyz(0, 0.1, 0);
  const std::vector<double> tiltedReference = test::referenceWigner(80, tilted);
  const double tiltedError = largestDifference(wignerMatrix(80, tilted), tiltedReference);
  EXPECT_LE(tiltedError, 3e-14);
  EXPECT_GE(largestDifference(test::realRecurrenceTurnAboutY(80, 0.1), tiltedReference), 1e6 * tiltedError);
}

}  // namespace
}  // namespace shprt
