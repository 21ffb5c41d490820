// The kernels of every instruction set that this processor has, against the plain baseline; and many sets at
// a time against one set at a time.
#include <gtest/gtest.h>

#include <cmath>
#include <thread>
#include <utility>
#include <vector>

#include "shprt/sh/basis.h"
#include "shprt/sh/processor.h"
#include "shprt/sh/rotation.h"
#include "shprt/sh/rotation_kernel_turns.h"
#include "shprt/sh/rotation_turns.h"
#include "shprt/sh/rotation_variants.h"

namespace shprt {
namespace {

std::vector<const RotationVariant*> availableVariants() {
  std::vector<const RotationVariant*> variants = {&kRotationBaseline};
#if defined(__x86_64__)
  if (hasAvx2()) variants.push_back(&kRotationAvx2);
  if (hasAvx512()) variants.push_back(&kRotationAvx512);
#endif
  return variants;
}

std::vector<double> someCoefficients(int degree) {
  std::vector<double> c;
  for (int i = 0; i < coefficientCount(degree); ++i) c.push_back(std::sin(1.7 * i + 0.4));
  return c;
}

const Mat3 kRotation = rotationFromEulerZyz(0.7, 2.1, -1.3);

TEST(RotationVariants, LowDegreesTouchTheirOwnCoefficientsOnlyAndAgree) {
  for (const RotationVariant* variant : availableVariants())
    for (int degree = 0; degree <= variant->lowDegree; ++degree) {
      const std::vector<double> before = someCoefficients(degree + 2);
      std::vector<double> after = before;
      variant->rotateLow(degree, unrolledSwaps(), kRotation, after.data());
      for (int i = 0; i < static_cast<int>(before.size()); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const int l = bandOf(i);
        if (l > degree) {
          EXPECT_EQ(after[at], before[at]) << variant->name << " " << degree << " " << i;
          continue;
        }
        // One band above what the kernels for low bands do, the general kernel takes over: the same matrix.
        const std::vector<double> matrix = wignerMatrix(l, kRotation);
        const auto size = static_cast<std::size_t>(2 * l + 1), row = at - static_cast<std::size_t>(l * l);
        double expected = 0;
        for (std::size_t k = 0; k < size; ++k)
          expected += matrix[row * size + k] * before[static_cast<std::size_t>(l * l) + k];
        EXPECT_NEAR(after[at], expected, 1e-14) << variant->name << " " << degree << " " << i;
      }
    }
}

TEST(RotationVariants, BandsAgree) {
  for (const int l : {1, 2, 3, 6, 7, 8, 9, 14, 15, 16, 17, 31, 32, 33, 46, 47, 48, 64, 97}) {
    const ZTurns turns = zTurns(kRotation);
    const TurnWorkspace workspace(l, turns.turns);
    std::vector<double> expected;
    for (const RotationVariant* variant : availableVariants()) {
      std::vector<double> set = someCoefficients(l);
      variant->rotateBand(cachedSwapBand(l), workspace.tables(), workspace.scratch(),
                          set.data() + shIndex(l, 0));
      if (expected.empty()) expected = set;
      for (std::size_t i = 0; i < set.size(); ++i)
        ASSERT_NEAR(set[i], expected[i], 2e-14) << variant->name << " " << l << " " << i;
    }
    // The low kernels have their own order of operations, but rotate the same.
    if (l > kScalarLowDegree) continue;
    std::vector<double> low = someCoefficients(l);
    kRotationBaseline.rotateLow(l, unrolledSwaps(), kRotation, low.data());
    for (std::size_t i = static_cast<std::size_t>(l * l); i < low.size(); ++i)
      ASSERT_NEAR(low[i], expected[i], 4e-15) << l << " " << i;
  }
}

// Products of a matrix with small whole numbers are exact in float, so every variant must give them.
TEST(RotationVariants, ManySetsAreExactInWholeNumbers) {
  for (const RotationVariant* variant : availableVariants())
    for (const int size : {1, 3, 5, 7, 9, 11, 17, 19})
      for (const std::size_t setCount : {1u, 15u, 16u, 33u, 700u})
        for (const auto& [pastCaches, stride] : {std::pair<bool, std::size_t>{false, setCount + 3},
                                                 {true, setCount + 3},
                                                 {true, (setCount + 31) / 16 * 16}}) {
          const auto rows = static_cast<std::size_t>(size);
          std::vector<float> matrix(rows * rows), from(rows * stride), to(rows * stride + 1, -1);
          for (std::size_t i = 0; i < matrix.size(); ++i) matrix[i] = static_cast<float>(i % 7) - 3;
          for (std::size_t i = 0; i < from.size(); ++i) from[i] = static_cast<float>(i % 11) - 5;
          struct alignas(64) Line {
            float entries[16];
          };
          std::vector<Line> scratch(2 * rows * kManyBlock / 16);
          variant->rotateManyBand(size, matrix.data(), from.data(), to.data() + 1, setCount, stride,
                                  pastCaches, scratch.front().entries);
          EXPECT_EQ(to[0], -1);
          for (std::size_t i = 0; i < rows; ++i)
            for (std::size_t set = 0; set < stride; ++set) {
              float expected = set < setCount ? 0.0f : -1.0f;
              if (set < setCount)
                for (std::size_t k = 0; k < rows; ++k)
                  expected += matrix[k * rows + i] * from[k * stride + set];
              ASSERT_EQ(to[1 + i * stride + set], expected)
                  << variant->name << " " << size << " " << setCount << " " << i << " " << set;
            }
        }
}

TEST(RotateMany, AgreesWithOneSetAtATime) {
  for (const int degree : {0, 1, 4, 9}) {
    // Enough, at degree 4, to go past the caches.
    const std::size_t setCount = degree == 4 ? 60'001 : 77, stride = setCount;
    const auto rows = static_cast<std::size_t>(coefficientCount(degree));
    std::vector<float> from(rows * stride), to(from.size());
    for (std::size_t i = 0; i < from.size(); ++i)
      from[i] = static_cast<float>(std::sin(0.37 * static_cast<double>(i)));
    const ShRotation rotation(degree, kRotation);
    rotateMany(rotation, from.data(), to.data(), setCount, stride);
    for (std::size_t set = 0; set < setCount; set += degree == 4 ? 997 : 1) {
      std::vector<double> expected;
      for (std::size_t i = 0; i < rows; ++i) expected.push_back(from[i * stride + set]);
      rotation.apply(expected);
      for (std::size_t i = 0; i < rows; ++i)
        ASSERT_NEAR(to[i * stride + set], expected[i], 1e-6) << degree << " " << set << " " << i;
    }
  }
}

TEST(RotationCache, MayBeFilledFromSeveralThreads) {
  std::vector<std::vector<double>> results(4, someCoefficients(60));
  {
    std::vector<std::jthread> threads;
    for (auto& result : results) threads.emplace_back([&result] { ShRotation(60, kRotation).apply(result); });
  }
  for (const auto& result : results) EXPECT_EQ(result, results[0]);
}

}  // namespace
}  // namespace shprt
