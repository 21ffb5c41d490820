// The scrambled Sobol sequence against the definitions of nets and of nested scrambling.
#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

#include "disc_integrands.h"
#include "shprt/sampling/scrambled_sobol.h"

namespace shprt {
namespace {

// One point in each of the 2^m elementary intervals of every shape 2^-a by 2^-(m-a).
bool isNet(std::span<const SquarePoint> points, int m) {
  for (int a = 0; a <= m; ++a) {
    std::vector<bool> taken(points.size());
    for (const SquarePoint p : points) {
      const auto column = static_cast<std::size_t>(std::ldexp(p.u, a));
      const auto row = static_cast<std::size_t>(std::ldexp(p.v, m - a));
      const std::size_t interval = (column << (m - a)) + row;
      if (interval >= taken.size() || taken[interval]) return false;
      taken[interval] = true;
    }
  }
  return true;
}

TEST(ScrambledSobol, EveryAlignedRunIsANet) {
  std::vector<SquarePoint> points;
  for (const int count : {1, 2, 8, 256, 300, 4096}) {
    const ScrambledSobol sequence(count);
    for (std::uint64_t key = 0; key < 5; ++key) {
      sequence.scramble(key, points);
      ASSERT_EQ(points.size(), static_cast<std::size_t>(count));
      for (int m = 0; (1 << m) <= count; ++m) {
        const std::size_t run = std::size_t{1} << m;
        for (std::size_t begin = 0; begin + run <= points.size(); begin += run)
          ASSERT_TRUE(isNet(std::span(points).subspan(begin, run), m)) << count << " " << begin << " " << m;
      }
    }
  }
  points = {{0.1, 0.1}, {0.4, 0.9}};
  EXPECT_FALSE(isNet(points, 1));
}

std::uint32_t sharedBits(double a, double b) {
  std::uint32_t shared = 0;
  while (shared < 32 && std::ldexp(a, static_cast<int>(shared) + 1) >= 0 &&
         std::floor(std::ldexp(a, static_cast<int>(shared) + 1)) ==
             std::floor(std::ldexp(b, static_cast<int>(shared) + 1)))
    ++shared;
  return shared;
}

// Nested scrambling is a tree's automorphism: how many leading bits two points share does not change.
TEST(ScrambledSobol, KeepsTheBitsThatPointsShare) {
  const ScrambledSobol sequence(64);
  std::vector<SquarePoint> points;
  for (std::uint64_t key = 0; key < 20; ++key) {
    sequence.scramble(key, points);
    for (std::uint32_t i = 0; i < 64; ++i)
      for (std::uint32_t j = 0; j < i; ++j) {
        ASSERT_EQ(sharedBits(points[i].u, points[j].u),
                  sharedBits(sequence.cellU(i) / 64.0, sequence.cellU(j) / 64.0));
        ASSERT_EQ(sharedBits(points[i].v, points[j].v),
                  sharedBits(sequence.cellV(i) / 64.0, sequence.cellV(j) / 64.0));
      }
  }
}

// Every bit of every point is a fair coin, and any two of the 16 x 2 x 6 are independent unless they are of
// the same bit of one axis below a common prefix: correlations of +-1 coins are within 5.5 standard errors.
TEST(ScrambledSobol, TossesFairAndIndependentCoins) {
  constexpr int kPoints = 16, kBits = 6, kKeys = 4000;
  const ScrambledSobol sequence(kPoints);
  std::vector<SquarePoint> points;
  constexpr std::size_t kCoins = kPoints * 2 * kBits;
  std::vector<double> sum(kCoins), products(kCoins * kCoins), coins(kCoins);
  const auto coin = [](int point, int axis, int bit) {
    return static_cast<std::size_t>((point * 2 + axis) * kBits + bit);
  };
  for (int key = 0; key < kKeys; ++key) {
    sequence.scramble(static_cast<std::uint64_t>(key), points);
    for (int p = 0; p < kPoints; ++p)
      for (int bit = 0; bit < kBits; ++bit) {
        const SquarePoint point = points[static_cast<std::size_t>(p)];
        coins[coin(p, 0, bit)] = std::fmod(std::floor(std::ldexp(point.u, bit + 1)), 2) * 2 - 1;
        coins[coin(p, 1, bit)] = std::fmod(std::floor(std::ldexp(point.v, bit + 1)), 2) * 2 - 1;
      }
    for (std::size_t i = 0; i < kCoins; ++i) {
      sum[i] += coins[i];
      for (std::size_t j = 0; j < i; ++j) products[i * kCoins + j] += coins[i] * coins[j];
    }
  }
  const double limit = 5.5 * std::sqrt(kKeys);
  for (int p = 0; p < kPoints; ++p)
    for (int axis = 0; axis < 2; ++axis)
      for (int bit = 0; bit < kBits; ++bit) {
        const std::size_t i = coin(p, axis, bit);
        EXPECT_LT(std::abs(sum[i]), limit);
        for (int q = 0; q <= p; ++q)
          for (int otherAxis = 0; otherAxis < 2; ++otherAxis)
            for (int otherBit = 0; otherBit < kBits; ++otherBit) {
              const std::size_t j = coin(q, otherAxis, otherBit);
              if (j >= i) continue;
              const auto cell = [&](int point) {
                const auto index = static_cast<std::uint32_t>(point);
                return axis == 0 ? sequence.cellU(index) : sequence.cellV(index);
              };
              const bool sameNode = axis == otherAxis && bit == otherBit && bit < sequence.bits() &&
                                    sharedBits(cell(p) / 16.0, cell(q) / 16.0) >= static_cast<unsigned>(bit);
              const double product = std::abs(products[i * kCoins + j]);
              if (sameNode)
                EXPECT_EQ(product, kKeys);
              else
                EXPECT_LT(product, limit);
            }
      }
}

// Along one axis, 2^m points have one in each of 2^m intervals, uniform and independent there: the variance
// of their mean is that of stratified sampling, 1/(12 n^3).
TEST(ScrambledSobol, HasTheVarianceOfStratifiedPointsAlongEachAxis) {
  constexpr int kCount = 32, kKeys = 4000;
  const ScrambledSobol sequence(kCount);
  std::vector<SquarePoint> points;
  test::Average squaresU, squaresV;
  for (std::uint64_t key = 0; key < kKeys; ++key) {
    sequence.scramble(key, points);
    double u = 0, v = 0;
    for (const SquarePoint p : points) u += p.u / kCount, v += p.v / kCount;
    squaresU.add((u - 0.5) * (u - 0.5));
    squaresV.add((v - 0.5) * (v - 0.5));
  }
  const double variance = 1 / (12.0 * kCount * kCount * kCount);
  EXPECT_NEAR(squaresU.mean(), variance, 5 * squaresU.standardError());
  EXPECT_NEAR(squaresV.mean(), variance, 5 * squaresV.standardError());
}

}  // namespace
}  // namespace shprt
