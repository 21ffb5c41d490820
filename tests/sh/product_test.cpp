// Triple products and products, against references, Wigner's 3j symbols, and values point by point.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <map>
#include <numbers>
#include <random>
#include <vector>

#include "shprt/sh/basis.h"
#include "shprt/sh/gauss_legendre.h"
#include "shprt/sh/product.h"
#include "tests/sh/quadrature.h"
#include "tests/sh/reference.h"

namespace shprt {
namespace {

using Indices = std::array<int, 3>;

std::map<Indices, double> entriesOf(const TripleProductTensor& tensor) {
  std::map<Indices, double> entries;
  for (const TripleProduct& t : tensor.entries()) entries[{t.i, t.j, t.k}] = t.value;
  EXPECT_EQ(entries.size(), tensor.entries().size()) << "an entry is listed twice";
  return entries;
}

double entry(const std::map<Indices, double>& entries, Indices indices) {
  const auto found = entries.find(indices);
  return found == entries.end() ? 0 : found->second;
}

std::vector<double> randomCoefficients(int degree, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<double> coefficients;
  for (int i = 0; i < coefficientCount(degree); ++i)
    coefficients.push_back(static_cast<double>(random() >> 11) * 0x1p-52 - 1);
  return coefficients;
}

double valueAt(const std::vector<double>& coefficients, Vec3d u) {
  std::vector<double> y(coefficients.size());
  evaluateSh(static_cast<int>(std::lround(std::sqrt(double(y.size())))) - 1, u, y);
  double value = 0;
  for (std::size_t i = 0; i < y.size(); ++i) value += coefficients[i] * y[i];
  return value;
}

double norm(const std::vector<double>& v) {
  double squared = 0;
  for (const double entry : v) squared += entry * entry;
  return std::sqrt(squared);
}

long double factorial(int n) {
  return std::tgamma(static_cast<long double>(n) + 1);
}

// Wigner's 3j symbol by Racah's sum.
long double wigner3j(int a, int b, int c, int alpha, int beta, int gamma) {
  if (alpha + beta + gamma != 0 || c < std::abs(a - b) || c > a + b) return 0;
  if (std::abs(alpha) > a || std::abs(beta) > b || std::abs(gamma) > c) return 0;
  long double sum = 0;
  for (int t = std::max({0, b - c - alpha, a - c + beta}); t <= std::min({a + b - c, a - alpha, b + beta});
       ++t)
    sum += (t % 2 ? -1 : 1) / (factorial(t) * factorial(c - b + t + alpha) * factorial(c - a + t - beta) *
                               factorial(a + b - c - t) * factorial(a - t - alpha) * factorial(b - t + beta));
  const long double delta =
      factorial(a + b - c) * factorial(a - b + c) * factorial(-a + b + c) / factorial(a + b + c + 1);
  return (std::abs(a - b - gamma) % 2 ? -1 : 1) * sum *
         std::sqrt(delta * factorial(a + alpha) * factorial(a - alpha) * factorial(b + beta) *
                   factorial(b - beta) * factorial(c + gamma) * factorial(c - gamma));
}

// y_lm in the complex harmonics with Condon-Shortley phase, Y_lM for M = |m| and M = -|m|.
struct ComplexParts {
  int order[2];
  std::complex<long double> factor[2];
  int count;
};
ComplexParts complexParts(int m) {
  const long double half = std::numbers::sqrt2_v<long double> / 2, sign = m % 2 ? -1 : 1;
  if (m == 0) return {{0, 0}, {1, 0}, 1};
  if (m > 0) return {{m, -m}, {sign * half, half}, 2};
  return {{-m, m}, {{0, -sign * half}, {0, half}}, 2};
}

long double gauntByWigner(int l1, int m1, int l2, int m2, int l3, int m3) {
  const ComplexParts p = complexParts(m1), q = complexParts(m2), r = complexParts(m3);
  std::complex<long double> sum = 0;
  for (int a = 0; a < p.count; ++a)
    for (int b = 0; b < q.count; ++b)
      for (int c = 0; c < r.count; ++c)
        sum += p.factor[a] * q.factor[b] * r.factor[c] *
               wigner3j(l1, l2, l3, p.order[a], q.order[b], r.order[c]);
  const long double pi = std::numbers::pi_v<long double>;
  return sum.real() * wigner3j(l1, l2, l3, 0, 0, 0) *
         std::sqrt((2 * l1 + 1.0L) * (2 * l2 + 1.0L) * (2 * l3 + 1.0L) / (4 * pi));
}

TEST(GaussLegendre, IntegratesPolynomialsExactly) {
  for (const int count : {1, 2, 3, 7, 32, 101}) {
    const GaussLegendreRule rule = gaussLegendre(count);
    for (int power = 0; power < 2 * count; ++power) {
      double sum = 0;
      for (std::size_t n = 0; n < rule.nodes.size(); ++n)
        sum += rule.weights[n] * std::pow(rule.nodes[n], power);
      EXPECT_NEAR(sum, power % 2 ? 0 : 2.0 / (power + 1), 4e-15) << count << " nodes, power " << power;
    }
  }
  for (const int count : {32, 1000}) {
    const GaussLegendreRule rule = gaussLegendre(count);
    const test::UnitRule reference = test::unitRule(count);  // on [0, 1], the distance from 1 halved
    for (std::size_t n = 0; n < rule.nodes.size(); ++n) {
      const std::size_t mirrored = rule.nodes.size() - 1 - n;
      EXPECT_NEAR(rule.nodes[mirrored], static_cast<double>(1 - 2 * reference.nodes[n]), 2e-16) << n;
      const auto weight = static_cast<double>(2 * reference.weights[n]);
      EXPECT_NEAR(rule.weights[mirrored], weight, (count == 32 ? 1e-15 : 2e-14) * weight) << n;
    }
  }
  const GaussLegendreRule three = gaussLegendre(3);
  EXPECT_DOUBLE_EQ(three.nodes[2], std::sqrt(0.6));
  EXPECT_EQ(three.nodes[1], 0);
  EXPECT_DOUBLE_EQ(three.weights[0], 5.0 / 9);
  EXPECT_DOUBLE_EQ(three.weights[1], 8.0 / 9);
}

TEST(TripleProductTensor, HasExactlyTheEntriesOfTheReference) {
  SHPRT_NEEDS_REFERENCE();
  const auto reference = test::readReference("zonal.json")["triple_product"];
  const int degree = reference["lmax"];
  std::map<Indices, double> expected;
  for (const auto& e : reference["entries"]) {
    Indices indices{e[0], e[1], e[2]};
    do expected[indices] = e[3].get<double>();
    while (std::next_permutation(indices.begin(), indices.end()));
  }
  ASSERT_GT(expected.size(), 300u);
  const std::map<Indices, double> entries = entriesOf(TripleProductTensor(degree, degree, degree));
  EXPECT_EQ(entries.size(), expected.size());
  for (const auto& [indices, value] : expected)
    EXPECT_NEAR(entry(entries, indices), value, 1e-15)
        << indices[0] << " " << indices[1] << " " << indices[2];
}

TEST(TripleProductTensor, AgreesWithWignerSymbolsForUnequalDegrees) {
  const int a = 5, b = 3, c = 7;
  const std::map<Indices, double> entries = entriesOf(TripleProductTensor(a, b, c));
  std::size_t nonzero = 0;
  for (int i = 0; i < coefficientCount(a); ++i)
    for (int j = 0; j < coefficientCount(b); ++j)
      for (int k = 0; k < coefficientCount(c); ++k) {
        const int l1 = bandOf(i), l2 = bandOf(j), l3 = bandOf(k);
        const auto expected = static_cast<double>(
            gauntByWigner(l1, i - shIndex(l1, 0), l2, j - shIndex(l2, 0), l3, k - shIndex(l3, 0)));
        ASSERT_NEAR(entry(entries, {i, j, k}), expected, 1e-15) << i << " " << j << " " << k;
        nonzero += std::fabs(expected) > 1e-10;
      }
  EXPECT_EQ(entries.size(), nonzero);
}

TEST(TripleProductTensor, KeepsItsAccuracyAtHighDegree) {
  const std::map<Indices, double> entries = entriesOf(TripleProductTensor(12, 1, 12));
  for (const auto& [indices, value] : entries) {
    const int l1 = bandOf(indices[0]), l2 = bandOf(indices[1]), l3 = bandOf(indices[2]);
    EXPECT_NEAR(
        value,
        static_cast<double>(gauntByWigner(l1, indices[0] - shIndex(l1, 0), l2, indices[1] - shIndex(l2, 0),
                                          l3, indices[2] - shIndex(l3, 0))),
        1e-15);
  }
}

TEST(TripleProductTensor, IsSymmetricAndOrdered) {
  const TripleProductTensor tensor(4, 4, 4);
  const std::map<Indices, double> entries = entriesOf(tensor);
  for (const auto& [indices, value] : entries) {
    const auto [i, j, k] = indices;
    for (const Indices& other : {Indices{j, i, k}, Indices{i, k, j}, Indices{k, j, i}})
      EXPECT_NEAR(entry(entries, other), value, 1e-15) << i << " " << j << " " << k;
  }
  const auto inOrder = [](const TripleProduct& a, const TripleProduct& b) {
    return Indices{a.i, a.j, a.k} < Indices{b.i, b.j, b.k};
  };
  EXPECT_TRUE(std::is_sorted(tensor.entries().begin(), tensor.entries().end(), inOrder));
}

// y_11^2 = 3/(4 pi) x^2, by hand in the basis: 1/sqrt(4 pi) y_00 - 1/sqrt(20 pi) y_20 + sqrt(3/(20 pi)) y_22.
TEST(Product, SquareOfABasisFunctionIsKnown) {
  using std::numbers::pi;
  const std::vector<double> x{0, 0, 0, 1};
  const std::vector<double> square = productCoefficients(x, x, 3);
  std::vector<double> expected(16, 0.0);
  expected[0] = 1 / std::sqrt(4 * pi);
  expected[6] = -1 / std::sqrt(20 * pi);
  expected[8] = std::sqrt(3 / (20 * pi));
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(square[i], expected[i], 4e-16) << i;
}

TEST(Product, AgreesPointByPointWhenTheDegreeHoldsItAll) {
  for (const auto& [degreeF, degreeG] :
       {std::pair{0, 0}, {0, 3}, {3, 0}, {1, 1}, {6, 9}, {9, 6}, {20, 17}, {40, 40}}) {
    const std::vector<double> f = randomCoefficients(degreeF, 1), g = randomCoefficients(degreeG, 2);
    const std::vector<double> product = productCoefficients(f, g, degreeF + degreeG);
    for (const Vec3d u : {Vec3d{0, 0, 1}, Vec3d{0, -1, 0}, normalize({0.3, 0.8, -0.2}),
                          normalize({-0.7, 0.1, 0.5}), normalize({1e-3, 2e-3, -1})}) {
      const double scale = norm(f) * norm(g) * (1 + degreeF) * (1 + degreeG);
      EXPECT_NEAR(valueAt(product, u), valueAt(f, u) * valueAt(g, u), 1e-14 * scale)
          << degreeF << " " << degreeG;
    }
  }
}

TEST(Product, TruncationKeepsTheLowerBands) {
  const std::vector<double> f = randomCoefficients(5, 3), g = randomCoefficients(7, 4);
  const std::vector<double> whole = productCoefficients(f, g, 14), commuted = productCoefficients(g, f, 14);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_NEAR(commuted[i], whole[i], 1e-15 * norm(f) * norm(g)) << i;
    if (bandOf(static_cast<int>(i)) > 12) {
      EXPECT_NEAR(whole[i], 0, 1e-14) << "beyond the degree of the product";
    }
  }
  for (const int degree : {0, 1, 4, 9, 12}) {
    const std::vector<double> part = productCoefficients(f, g, degree);
    for (std::size_t i = 0; i < part.size(); ++i) EXPECT_NEAR(part[i], whole[i], 1e-14) << degree << " " << i;
  }
}

TEST(Product, TensorAndMatrixAndDirectFormAgree) {
  for (const Indices& degrees : {Indices{4, 4, 4}, {0, 5, 5}, {5, 0, 3}, {3, 6, 2}, {6, 2, 8}, {2, 9, 9}}) {
    const auto [degreeF, degreeG, degreeProduct] = degrees;
    const std::vector<double> f = randomCoefficients(degreeF, 5), g = randomCoefficients(degreeG, 6);
    const std::vector<double> direct = productCoefficients(f, g, degreeProduct);
    std::vector<double> byTensor(direct.size(), 1e9);
    TripleProductTensor(degreeF, degreeG, degreeProduct).multiply(f, g, byTensor);
    const std::vector<double> matrix = productMatrix(f, degreeG, degreeProduct);
    ASSERT_EQ(matrix.size(), direct.size() * g.size());
    for (std::size_t k = 0; k < direct.size(); ++k) {
      double byMatrix = 0;
      for (std::size_t j = 0; j < g.size(); ++j) byMatrix += matrix[k * g.size() + j] * g[j];
      EXPECT_NEAR(byTensor[k], direct[k], 2e-14)
          << degreeF << " " << degreeG << " " << degreeProduct << " " << k;
      EXPECT_NEAR(byMatrix, direct[k], 2e-14)
          << degreeF << " " << degreeG << " " << degreeProduct << " " << k;
    }
  }
}

TEST(Product, MatrixIsSymmetricAndOneIsItsUnit) {
  const std::vector<double> matrix = productMatrix(randomCoefficients(9, 8), 6, 6);
  for (std::size_t j = 0; j < 49; ++j)
    for (std::size_t k = 0; k < 49; ++k) EXPECT_NEAR(matrix[k * 49 + j], matrix[j * 49 + k], 1e-14);
  const std::vector<double> one{std::sqrt(4 * std::numbers::pi)};
  const std::vector<double> identity = productMatrix(one, 8, 8);
  for (std::size_t k = 0; k < 81; ++k)
    for (std::size_t j = 0; j < 81; ++j) EXPECT_NEAR(identity[k * 81 + j], j == k, 2e-15) << k << " " << j;
  const std::vector<double> f = randomCoefficients(100, 9), same = productCoefficients(f, one, 100);
  for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(same[i], f[i], 1e-15 * norm(f) * norm(one)) << i;
}

}  // namespace
}  // namespace shprt
