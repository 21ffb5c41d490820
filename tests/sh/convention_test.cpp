// Conventions against the formulas by which their owners rebuild a function, written out here, and against
// closed forms.
#include "shprt/sh/convention.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/base/vec.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/moments.h"
#include "shprt/sh/zonal.h"

namespace shprt {
namespace {

using std::numbers::pi;
using Values = std::vector<double>;

// No symmetry, and no two alike, so that an exchange or a lost sign shows.
Values someCoefficients(int degree) {
  Values c;
  for (int i = 0; i < coefficientCount(degree); ++i) c.push_back(std::cos(1.7 * i * i + 0.3) + 0.2);
  return c;
}

std::vector<Vec3d> someDirections() {
  std::vector<Vec3d> directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  for (int i = 0; i < 40; ++i)
    directions.push_back(normalize(Vec3d{std::sin(i + 0.1), std::cos(2.3 * i), std::sin(3.1 * i + 1)}));
  return directions;
}

double evaluate(const Values& c, int degree, Vec3d w) {
  Values basis(c.size());
  evaluateSh(degree, w, basis);
  double sum = 0;
  for (std::size_t i = 0; i < c.size(); ++i) sum += c[i] * basis[i];
  return sum;
}

double irradianceOverPi(const Values& c, int degree, Vec3d normal) {
  const Values cosine = clampedCosineFactors(degree);
  Values convolved = c;
  for (int l = 0; l <= degree; ++l)
    for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i)
      convolved[static_cast<std::size_t>(i)] *= cosine[static_cast<std::size_t>(l)] / pi;
  return evaluate(convolved, degree, normal);
}

// What Unity's and Filament's shaders add up.
double plainPolynomials(const Values& v, Vec3d n) {
  return v[0] + v[1] * n.y + v[2] * n.z + v[3] * n.x + v[4] * n.x * n.y + v[5] * n.y * n.z +
         v[6] * (3 * n.z * n.z - 1) + v[7] * n.x * n.z + v[8] * (n.x * n.x - n.y * n.y);
}

// Six-digit constants, as engines write them.
double sixDigitBasis(const Values& v, Vec3d w, double phase) {
  return 0.282095 * v[0] + phase * 0.488603 * v[1] * w.y + 0.488603 * v[2] * w.z +
         phase * 0.488603 * v[3] * w.x + 1.092548 * v[4] * w.x * w.y + phase * 1.092548 * v[5] * w.y * w.z +
         0.315392 * v[6] * (3 * w.z * w.z - 1) + phase * 1.092548 * v[7] * w.x * w.z +
         0.546274 * v[8] * (w.x * w.x - w.y * w.y);
}

TEST(Moments, RebuildTheFunctionAndItsCoefficients) {
  for (const int degree : {0, 1, 2}) {
    const Values c = someCoefficients(degree);
    const Moments moments = momentsOf(c);
    for (const Vec3d w : someDirections())
      EXPECT_NEAR(evaluateMoments(moments, w), evaluate(c, degree, w), 4e-15) << degree;
    const Values back = coefficientsOf(moments, degree);
    for (std::size_t i = 0; i < c.size(); ++i) EXPECT_NEAR(back[i], c[i], 1e-15) << degree << " " << i;
    EXPECT_NEAR(moments.matrix.m[0][0] + moments.matrix.m[1][1] + moments.matrix.m[2][2], 0, 1e-16);
  }
}

// A point of light with average 1: its vector is its direction, its matrix n n^T - I/3.
TEST(Moments, OfAPointOfLight) {
  for (const Vec3d n : someDirections()) {
    Values c(9);
    evaluateSh(2, n, c);
    for (double& value : c) value *= 4 * pi;
    const Moments moments = momentsOf(c);
    EXPECT_NEAR(moments.mean, 1, 1e-15);
    EXPECT_NEAR(length(moments.vector), 1, 1e-15);
    EXPECT_NEAR(dot(moments.vector, n), 1, 1e-15);
    const double u[3] = {n.x, n.y, n.z};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        EXPECT_NEAR(moments.matrix.m[i][j], u[i] * u[j] - (i == j ? 1.0 / 3 : 0), 2e-15);
  }
}

TEST(Moments, TurnWithTheirFunctionEvenInAMirror) {
  const Values c = someCoefficients(2);
  const Mat3 turned{{{0.6, 0, 0.8}, {0, -1, 0}, {-0.8, 0, 0.6}}};  // a turn and a reflection of y
  const Moments moments = transformMoments(momentsOf(c), turned);
  for (const Vec3d w : someDirections())
    EXPECT_NEAR(evaluateMoments(moments, turned * w), evaluate(c, 2, w), 4e-15);
}

TEST(Conventions, EngineFormulasRebuildTheLight) {
  const Values c = someCoefficients(2);
  const auto in = [&](Convention convention) { return toConvention(convention, 2, c); };
  for (const Vec3d w : someDirections()) {
    const double radiance = evaluate(c, 2, w), lambert = irradianceOverPi(c, 2, w);
    const Vec3d unity{-w.x, w.y, w.z}, unreal{w.x, w.z, w.y};
    EXPECT_NEAR(sixDigitBasis(in(Convention::kThreeJs), w, 1), radiance, 1e-5);
    EXPECT_NEAR(sixDigitBasis(in(Convention::kUnreal), unreal, -1), radiance, 1e-5);
    EXPECT_NEAR(sixDigitBasis(in(Convention::kCondonShortley), w, -1), radiance, 1e-5);
    EXPECT_NEAR(plainPolynomials(in(Convention::kUnity), unity), lambert, 4e-15);
    EXPECT_NEAR(plainPolynomials(in(Convention::kFilament), w), lambert, 4e-15);
    EXPECT_NEAR(sixDigitBasis(in(Convention::kGltf), w, 1), pi * lambert, 1e-5);
    const Values r = in(Convention::kL1Vector);
    const Vec3d product = Mat3{{{r[4], r[7], r[8]}, {r[7], r[5], r[9]}, {r[8], r[9], r[6]}}} * w;
    EXPECT_NEAR(r[0] + 3 * dot(Vec3d{r[1], r[2], r[3]}, w) + 7.5 * dot(w, product), radiance, 4e-15);
  }
}

// Light of radiance 1 from everywhere, and a sun of irradiance 1 along +X of this project.
TEST(Conventions, HaveTheirClosedForms) {
  Values constant(9, 0.0), sun(9);
  constant[0] = std::sqrt(4 * pi);
  evaluateSh(2, Vec3d{1, 0, 0}, sun);
  const auto expectValues = [](Convention convention, const Values& c, const Values& expected) {
    const Values values = toConvention(convention, 2, c);
    ASSERT_EQ(values.size(), expected.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(values[i], expected[i], 1e-15) << conventionFacts(convention).name << " " << i;
  };
  const double root = std::sqrt(4 * pi), c1 = std::sqrt(3 / (4 * pi)), c20 = std::sqrt(5 / (16 * pi)),
               c22 = std::sqrt(15 / (16 * pi)), c0 = 1 / root;
  expectValues(Convention::kThreeJs, constant, {root, 0, 0, 0, 0, 0, 0, 0, 0});
  expectValues(Convention::kUnreal, constant, {root, 0, 0, 0, 0, 0, 0, 0, 0});
  expectValues(Convention::kUnity, constant, {1, 0, 0, 0, 0, 0, 0, 0, 0});
  expectValues(Convention::kFilament, constant, {1, 0, 0, 0, 0, 0, 0, 0, 0});
  expectValues(Convention::kL1Vector, constant, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  expectValues(Convention::kGltf, constant, {pi * root, 0, 0, 0, 0, 0, 0, 0, 0});
  expectValues(Convention::kThreeJs, sun, {c0, 0, 0, c1, 0, 0, -c20, 0, c22});
  expectValues(Convention::kGltf, sun,
               {pi * c0, 0, 0, 2 * pi / 3 * c1, 0, 0, -pi / 4 * c20, 0, pi / 4 * c22});
  expectValues(Convention::kUnreal, sun, {c0, 0, 0, -c1, 0, 0, -c20, 0, c22});
  // E/pi = (1/4pi)(1 + 2 n.s + 5/4 (3 (n.s)^2 - 1)/2), n.s = x, 3x^2 - 1 = 3/2 (x^2-y^2) - (3z^2-1)/2.
  const double k = 1 / (4 * pi);
  expectValues(Convention::kFilament, sun, {k, 0, 0, 2 * k, 0, 0, -5 * k / 16, 0, 15 * k / 16});
  expectValues(Convention::kUnity, sun, {k, 0, 0, -2 * k, 0, 0, -5 * k / 16, 0, 15 * k / 16});
  expectValues(Convention::kL1Vector, sun, {k, k, 0, 0, 2 * k / 3, -k / 3, -k / 3, 0, 0, 0});
}

TEST(Conventions, ComeBackToRounding) {
  for (const ConventionFacts& facts : allConventions())
    for (int degree = facts.minimumDegree; degree <= std::min(facts.maximumDegree, 40); ++degree) {
      const Values c = someCoefficients(degree);
      const Values values = toConvention(facts.convention, degree, c);
      EXPECT_EQ(values.size(), static_cast<std::size_t>(conventionSize(facts.convention, degree)));
      const Values back = fromConvention(facts.convention, degree, values);
      ASSERT_EQ(back.size(), c.size());
      for (std::size_t i = 0; i < c.size(); ++i)
        EXPECT_NEAR(back[i], c[i], facts.maximumDegree > 2 ? 0 : 2e-15)
            << facts.name << " " << degree << " " << i;
    }
}

TEST(Conventions, CondonShortleyChangesOddOrdersAtAnyDegree) {
  const Values c = someCoefficients(7), values = toConvention(Convention::kCondonShortley, 7, c);
  for (int l = 0; l <= 7; ++l)
    for (int m = -l; m <= l; ++m) {
      const auto i = static_cast<std::size_t>(shIndex(l, m));
      EXPECT_EQ(values[i], m % 2 == 0 ? c[i] : -c[i]) << l << " " << m;
    }
}

TEST(Conventions, AreFoundByName) {
  for (const ConventionFacts& facts : allConventions()) {
    EXPECT_EQ(parseConvention(facts.name), facts.convention);
    EXPECT_EQ(&conventionFacts(facts.convention), &facts);
  }
  try {
    parseConvention("godot");
    ADD_FAILURE() << "an unknown convention was found";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("l1-vector, three.js, unity"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace shprt
