// Rotations against 50-digit matrices, against the definition, and at the places where Euler angles break.
#include <gtest/gtest.h>

#include <cmath>
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
    for (int l = 0; l <= 6; ++l)
      for (int n = -l; n <= l; ++n) {
        std::vector<double> unit(static_cast<std::size_t>(coefficientCount(6)));
        unit[static_cast<std::size_t>(shIndex(l, n))] = 1;
        const std::vector<double> column = rotated(unit, matrix);
        for (int m = -l; m <= l; ++m) {
          const double expected =
              entry["D"][static_cast<std::size_t>(l)].is_array() &&
                      entry["D"][static_cast<std::size_t>(l)][0].is_array()
                  ? entry["D"][static_cast<std::size_t>(l)][static_cast<std::size_t>(m + l)]
                         [static_cast<std::size_t>(n + l)]
                             .get<double>()
                  : entry["D"][static_cast<std::size_t>(l)]
                         [static_cast<std::size_t>((m + l) * (2 * l + 1) + n + l)]
                             .get<double>();
          ASSERT_NEAR(column[static_cast<std::size_t>(shIndex(l, m))], expected, 4e-15)
              << entry["name"] << " " << l << " " << m << " " << n;
        }
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
      ASSERT_NEAR(result[i], entry["rotated"][i].get<double>(), 4e-14) << entry["name"] << " " << i;
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
