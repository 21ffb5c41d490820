// Rotations against 50-digit matrices, against the definition, and at the places where Euler angles break.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"
#include "tests/scratch.h"
#include "tests/sh/reference.h"

namespace shprt {
namespace {

std::vector<double> rotated(std::vector<double> coefficients, const Mat3& rotation) {
  const int degree = bandOf(static_cast<int>(coefficients.size()) - 1);
  ShRotation(degree, rotation).apply(coefficients);
  return coefficients;
}

std::vector<double> someCoefficients(int degree) {
  std::vector<double> c;
  for (int i = 0; i < coefficientCount(degree); ++i) c.push_back(std::sin(1.7 * i + 0.4));
  return c;
}

std::vector<Mat3> hardRotations() {
  std::vector<Mat3> rotations;
  for (const char* spec :
       {"axis:1,2,3,0", "axis:1,0,0,180", "axis:0,1,0,180", "axis:0,0,1,180", "axis:0,0,1,37",
        "axis:1,1,1,120", "axis:1,0,0,90", "axis:0,1,0,90", "axis:1,2,0,1e-6", "euler:zyz,20,180,30",
        "euler:zyz,20,1e-10,30", "euler:zyz,10,5.7,200", "euler:zyz,10,172,-20", "axis:-1,2,0.5,77"}) {
    rotations.push_back(parseRotation(spec));
  }
  return rotations;
}

TEST(Rotation, MatricesAgreeWithTheReference) {
  SHPRT_NEEDS_REFERENCE();
  const auto reference = test::readReference("rotation.json");
  ASSERT_GT(reference["rotations"].size(), 5u);
  for (const auto& entry : reference["rotations"]) {
    Mat3 matrix;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) matrix.m[i][j] = entry["matrix"][i][j];
    for (int l = 0; l <= 6; ++l) {
      const std::vector<double> d = wignerMatrix(l, matrix);
      std::vector<double> expected;
      for (const auto& row : entry["D"][static_cast<std::size_t>(l)])
        for (const auto& number : row) expected.push_back(number.get<double>());
      ASSERT_EQ(d.size(), expected.size());
      for (std::size_t i = 0; i < d.size(); ++i)
        ASSERT_NEAR(d[i], expected[i], 2.5e-15) << entry["name"] << " " << l << " " << i;
    }
  }
}

TEST(Rotation, VectorsToDegree50AgreeWithTheReference) {
  SHPRT_NEEDS_REFERENCE();
  const auto reference = test::readReference("rotation.json");
  for (const auto& entry : reference["rotations"]) {
    Mat3 matrix;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) matrix.m[i][j] = entry["matrix"][i][j];
    const int degree = entry["rotated_lmax"];
    std::vector<double> c;
    for (std::size_t i = 0; i < static_cast<std::size_t>(coefficientCount(degree)); ++i)
      c.push_back(reference["coefficients"][i]);
    const std::vector<double> result = rotated(c, matrix);
    for (std::size_t i = 0; i < result.size(); ++i)
      ASSERT_NEAR(result[i], entry["rotated"][i].get<double>(), 2e-14) << entry["name"] << " " << i;
  }
}

// y_l(R u) = D y_l(u): a rotated point light stands where its direction went.
TEST(Rotation, TurnsDirectionsAlong) {
  const int degree = 12;
  std::vector<double> before(static_cast<std::size_t>(coefficientCount(degree))), after(before.size());
  for (const Mat3& rotation : hardRotations())
    for (const Vec3d direction : {Vec3d{0, 0, 1}, Vec3d{0, 0, -1}, Vec3d{1, 0, 0}, normalize({1, -2, 0.5}),
                                  normalize({1e-9, 0, -1})}) {
      evaluateSh(degree, direction, before);
      evaluateSh(degree, rotation * direction, after);
      const std::vector<double> result = rotated(before, rotation);
      for (std::size_t i = 0; i < after.size(); ++i) ASSERT_NEAR(result[i], after[i], 3e-13);
    }
}

TEST(Rotation, KeepsTheNormToDegree200) {
  const std::vector<double> c = someCoefficients(200);
  for (const Mat3& rotation : hardRotations()) {
    const std::vector<double> result = rotated(c, rotation);
    for (const int l : {1, 50, 200}) {
      double before = 0, after = 0;
      for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i) {
        before += c[static_cast<std::size_t>(i)] * c[static_cast<std::size_t>(i)];
        after += result[static_cast<std::size_t>(i)] * result[static_cast<std::size_t>(i)];
      }
      EXPECT_NEAR(after / before, 1, 1e-13) << l;
    }
  }
}

TEST(Rotation, ComposesAndInverts) {
  const std::vector<double> c = someCoefficients(10);
  const std::vector<Mat3> rotations = hardRotations();
  for (std::size_t i = 0; i + 1 < rotations.size(); ++i) {
    const std::vector<double> steps = rotated(rotated(c, rotations[i]), rotations[i + 1]);
    const std::vector<double> once = rotated(c, rotations[i + 1] * rotations[i]);
    const std::vector<double> back = rotated(rotated(c, rotations[i]), transpose(rotations[i]));
    for (std::size_t k = 0; k < c.size(); ++k) {
      ASSERT_NEAR(steps[k], once[k], 1e-13);
      ASSERT_NEAR(back[k], c[k], 1e-13);
    }
  }
}

TEST(Rotation, AppliesToSeveralSetsAlike) {
  std::vector<double> a = someCoefficients(5), b = a;
  for (double& value : b) value *= -2;
  const std::span<double> sets[] = {a, b};
  ShRotation(5, parseRotation("axis:1,2,3,40")).apply(sets);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_DOUBLE_EQ(b[i], -2 * a[i]);
  EXPECT_EQ(a, rotated(someCoefficients(5), parseRotation("axis:1,2,3,40")));
}

// A turn about z touches the pairs (m, -m) alone; the identity touches nothing.
TEST(Rotation, IsExactAboutZ) {
  const std::vector<double> c = someCoefficients(40);
  EXPECT_EQ(rotated(c, Mat3{}), c);
  const std::vector<double> half = rotated(c, parseRotation("axis:0,0,1,180"));
  const std::vector<double> quarter = rotated(c, parseRotation("axis:0,0,1,90"));
  for (int l = 0; l <= 40; ++l)
    for (int m = -l; m <= l; ++m) {
      const auto at = static_cast<std::size_t>(shIndex(l, m)),
                 mirrored = static_cast<std::size_t>(shIndex(l, -m));
      EXPECT_EQ(half[at], m % 2 ? -c[at] : c[at]);
      // cos(m (phi - 90 degrees)) and sin of the same, by m mod 4.
      const int n = std::abs(m) % 4;
      const double sign = n == 2 || (n == 1 && m > 0) || (n == 3 && m < 0) ? -1 : 1;
      EXPECT_EQ(quarter[at], sign * (n % 2 ? c[mirrored] : c[at])) << l << " " << m;
    }
}

TEST(Rotation, RefusesDegreesOutOfRange) {
  EXPECT_THROW(ShRotation(-1, Mat3{}), Error);
  EXPECT_THROW(ShRotation(kMaximumRotationDegree + 1, Mat3{}), Error);
  EXPECT_THROW(wignerMatrix(2, {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}), Error);
}

TEST(Rotation, TellsWhatItCorrected) {
  EXPECT_EQ(ShRotation(3, parseRotation("axis:1,2,3,40")).correction(), 0);
  Mat3 off = parseRotation("axis:0,0,1,90");
  off.m[0][1] -= 3e-5;
  const ShRotation mended(3, off);
  EXPECT_NEAR(mended.correction(), 3e-5, 1e-8);
  EXPECT_NEAR(mended.matrix().m[0][1], -1, 1e-15);
  const NearestRotation parsed = parseNearestRotation("matrix:0,-1.00003,0, 1,0,0, 0,0,1");
  EXPECT_NEAR(parsed.correction, 3e-5, 1e-8);
  EXPECT_EQ(parseNearestRotation("quat:1,2,3,4").correction, 0);
}

// Products and transposes of rotations are those of their matrices.
TEST(WignerMatrix, IsARepresentation) {
  const std::vector<Mat3> rotations = hardRotations();
  for (const int l : {1, 3, 8})
    for (std::size_t i = 0; i + 1 < rotations.size(); ++i) {
      const auto size = static_cast<std::size_t>(2 * l + 1);
      const std::vector<double> a = wignerMatrix(l, rotations[i]), b = wignerMatrix(l, rotations[i + 1]);
      const std::vector<double> both = wignerMatrix(l, rotations[i] * rotations[i + 1]);
      const std::vector<double> back = wignerMatrix(l, transpose(rotations[i]));
      for (std::size_t m = 0; m < size; ++m)
        for (std::size_t n = 0; n < size; ++n) {
          double sum = 0;
          for (std::size_t k = 0; k < size; ++k) sum += a[m * size + k] * b[k * size + n];
          ASSERT_NEAR(both[m * size + n], sum, 2e-14);
          ASSERT_NEAR(back[m * size + n], a[n * size + m], 1e-14);
        }
    }
}

TEST(WignerMatrix, HasThePolynomialsOfBandTwo) {
  const double angle = 0.4;
  const std::vector<double> d = wignerMatrix(2, rotationFromEulerZyz(0, angle, 0));
  const double c = std::cos(angle), s = std::sin(angle), root = std::sqrt(3.0);
  // Rows and columns m = -2..2 of xy, yz, 3z^2-1, xz, x^2-y^2 under x' = cx + sz, z' = cz - sx.
  const double expected[5][5] = {{c, s, 0, 0, 0},
                                 {-s, c, 0, 0, 0},
                                 {0, 0, (3 * c * c - 1) / 2, -root * s * c, root / 2 * s * s},
                                 {0, 0, root * s * c, c * c - s * s, -s * c},
                                 {0, 0, root / 2 * s * s, s * c, (1 + c * c) / 2}};
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < 5; ++j) EXPECT_NEAR(d[i * 5 + j], expected[i][j], 1e-15) << i << " " << j;
}

TEST(RotationMatrix, FromQuaternionsOfAnyLength) {
  const Mat3 third = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};  // x to y to z to x
  for (const double length : {1.0, -3.0, 1e-200, 1e300}) {
    const Mat3 matrix = rotationFromQuaternion(length, length, length, length);
    EXPECT_EQ(matrix, third) << length;
  }
  EXPECT_EQ(rotationFromQuaternion(0, 0, 5, 0), (Mat3{{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}));
  EXPECT_THROW(rotationFromQuaternion(0, 0, 0, 0), Error);
  EXPECT_THROW(rotationFromQuaternion(NAN, 0, 0, 1), Error);
  EXPECT_THROW(rotationFromQuaternion(INFINITY, 0, 0, 1), Error);
}

TEST(RotationMatrix, FromEulerAnglesIsTheProductOfItsTurns) {
  const double degree = std::numbers::pi / 180;
  const Mat3 matrix = rotationFromEulerZyz(30 * degree, 40 * degree, 50 * degree);
  const Mat3 expected = parseRotation("euler:zyz,30,40,50");
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(matrix.m[i][j], expected.m[i][j], 4e-16);
  EXPECT_THROW(rotationFromEulerZyz(0, NAN, 0), Error);
}

TEST(NearestRotation, MendsRoundingAndRefusesTheRest) {
  Mat3 rounded = parseRotation("axis:1,2,3,40");
  for (auto& row : rounded.m)
    for (double& entry : row) entry = std::round(entry * 1e4) / 1e4;
  const NearestRotation nearest = nearestRotation(rounded);
  EXPECT_GT(nearest.correction, 1e-6);
  EXPECT_LT(nearest.correction, 1e-4);
  const Mat3 product = transpose(nearest.rotation) * nearest.rotation;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(product.m[i][j], i == j, 1e-15);
  EXPECT_THROW(nearestRotation({{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}), Error);
  EXPECT_THROW(nearestRotation({{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}), Error);
  EXPECT_THROW(nearestRotation({{{1, 0.1, 0}, {0, 1, 0}, {0, 0, 1}}}), Error);
  EXPECT_THROW(nearestRotation({{{NAN, 0, 0}, {0, 1, 0}, {0, 0, 1}}}), Error);
}

TEST(ParseRotation, ReadsEveryForm) {
  const Mat3 quarter = {{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}};  // 90 degrees about +y takes +z to +x
  EXPECT_EQ(parseRotation("axis:0,1,0,90"), quarter);
  EXPECT_EQ(parseRotation(" axis: 0 , 2 , 0 , -270 "), quarter);
  EXPECT_EQ(parseRotation("matrix:0 0 1  0 1 0  -1 0 0"), quarter);
  EXPECT_EQ(parseRotation("euler:zyz,0,90,0"), quarter);
  const double h = std::sqrt(0.5);
  const Mat3 byQuaternion = parseRotation("quat:1,0,1,0");
  const Mat3 twoTurns = parseRotation("euler:zyz,30,40,50");
  const Mat3 expected =
      parseRotation("axis:0,0,1,30") * parseRotation("axis:0,1,0,40") * parseRotation("axis:0,0,1,50");
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(byQuaternion.m[i][j], quarter.m[i][j], 1e-15);
      EXPECT_EQ(twoTurns.m[i][j], expected.m[i][j]);
    }
  EXPECT_NEAR((parseRotation("axis:0,0,1,45") * Vec3d{1, 0, 0}).y, h, 1e-15);
  const std::string file = test::scratch("rotation.txt");
  std::ofstream(file) << "axis:0,1,0,90\n";
  EXPECT_EQ(parseRotation("@" + file), quarter);
}

TEST(ParseRotation, RefusesEverythingElseInOneLine) {
  for (const char* bad : {"", "axis", "axis:", "axis:0,1,0", "axis:0,1,0,90,1", "axis:0,0,0,90",
                          "axis:0,1,0,x", "axis:0,1,0,nan", "axis:0,1,0,90,", "quat:0,0,0,0", "quat:1,0,0",
                          "euler:xyz,1,2,3", "euler:1,2,3", "matrix:1,2,3", "matrix:1,0,0,0,1,0,0,0,-1",
                          "matrix:2,0,0,0,2,0,0,0,2", "turn:1,2,3", "@/no/such/file", "axis:inf,0,0,1"}) {
    try {
      parseRotation(bad);
      ADD_FAILURE() << bad << " was taken";
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace shprt
