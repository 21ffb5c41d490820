// What generated code computes, in every language, against the library and against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"
#include "shprt/sh/zonal.h"
#include "tests/codegen/compiled_code.h"
#include "tests/sh/reference.h"

#define SHPRT_NEEDS_COMPILER(language) \
  if (!test::haveCompilerFor(language)) GTEST_SKIP() << "SKIPPED: no compiler for this language"

namespace shprt {
namespace {

using std::numbers::pi;

double bandScale(int l) {
  return std::sqrt((2 * l + 1) / (4 * pi));
}

// Components rounded to float, so that code in float sees exactly these.
Vec3d asFloat(Vec3d v) {
  return toDouble(toFloat(v));
}

// Axes, the neighbourhood of both poles and of the equator, and directions everywhere.
std::vector<Vec3d> directions(int count) {
  std::vector<Vec3d> result = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> exponent(-9, 0.3);
  for (int i = 0; i < count; ++i) {
    const Vec3d d = normalize(Vec3d{normal(random), normal(random), normal(random)});
    const double small = std::pow(10, exponent(random));
    result.push_back(d);
    result.push_back(normalize(Vec3d{d.x * small, d.y * small, d.z > 0 ? 1.0 : -1.0}));
    result.push_back(normalize(Vec3d{d.x, d.y, d.z * small}));
  }
  return result;
}

std::vector<double> someColours(int degree, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::vector<double> colours(static_cast<std::size_t>(3 * coefficientCount(degree)));
  for (double& colour : colours) colour = static_cast<double>(uniform(random));
  return colours;
}

// What an y_lm may be off by, over bandScale.
double tolerance(int l, bool doublePrecision) {
  return doublePrecision ? 3e-14 : l <= 8 ? 1e-6 : 3e-6;
}

void checkBasis(const std::vector<double>& values, Vec3d direction, int degree, bool doublePrecision) {
  std::vector<double> expected(static_cast<std::size_t>(coefficientCount(degree)));
  evaluateSh(degree, normalize(direction), expected);
  for (int i = 0; i < coefficientCount(degree); ++i) {
    const int l = bandOf(i);
    ASSERT_NEAR(values[static_cast<std::size_t>(i)], expected[static_cast<std::size_t>(i)],
                tolerance(l, doublePrecision) * bandScale(l))
        << i << " at " << direction.x << " " << direction.y << " " << direction.z;
  }
}

// Checks radiance or irradiance against the sum of factors[l] c_i y_i; the errors of its terms may add up.
void checkSum(const std::vector<double>& values, const std::vector<double>& colours, Vec3d direction,
              const std::vector<double>& factors, bool doublePrecision) {
  const int degree = static_cast<int>(factors.size()) - 1;
  std::vector<double> basis(static_cast<std::size_t>(coefficientCount(degree)));
  evaluateSh(degree, normalize(direction), basis);
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0, allowed = 0;
    for (int i = 0; i < coefficientCount(degree); ++i) {
      const int l = bandOf(i);
      const auto k = static_cast<std::size_t>(i);
      const double weighted = factors[static_cast<std::size_t>(l)] * colours[3 * k + c];
      sum += weighted * basis[k];
      allowed += std::fabs(weighted) * bandScale(l) * tolerance(l, doublePrecision);
    }
    ASSERT_NEAR(values[c], sum, allowed) << "channel " << c;
  }
}

// With entries rounded to float, so that code in float sees exactly these, or as they are.
std::vector<Mat3> hardRotations(bool rounded) {
  std::vector<Mat3> rotations;
  for (const char* spec :
       {"axis:1,2,3,0", "axis:1,0,0,180", "axis:0,1,0,180", "axis:0,0,1,180", "axis:0,0,1,37",
        "axis:1,1,1,120", "axis:1,0,0,90", "axis:0,1,0,-90", "axis:1,2,0,1e-6", "euler:zyz,20,180,30",
        "euler:zyz,20,1e-10,30", "euler:zyz,10,5.7,200", "euler:zyz,10,172,-20", "axis:-1,2,0.5,77"})
    rotations.push_back(parseRotation(spec));
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 40; ++i) {
    std::string spec = "quat:";
    for (int k = 0; k < 4; ++k) spec += (k ? "," : "") + std::to_string(normal(random));
    rotations.push_back(parseRotation(spec));
  }
  if (!rounded) return rotations;
  for (Mat3& rotation : rotations)
    for (auto& row : rotation.m)
      for (double& entry : row) entry = static_cast<double>(static_cast<float>(entry));
  return rotations;
}

// Largest error of a rotated channel and band over the norm of that band.
double rotationError(const test::CompiledCode& code, int degree, const Mat3& rotation) {
  const std::vector<double> colours = someColours(degree, 3);
  const std::vector<double> values = code.rotate(rotation, colours);
  double worst = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<double> expected;
    for (int i = 0; i < coefficientCount(degree); ++i)
      expected.push_back(colours[3 * static_cast<std::size_t>(i) + c]);
    ShRotation(degree, rotation).apply(expected);
    for (int l = 0; l <= degree; ++l) {
      double norm = 0, largest = 0;
      for (int m = -l; m <= l; ++m) {
        const auto k = static_cast<std::size_t>(shIndex(l, m));
        norm += expected[k] * expected[k];
        largest = std::fmax(largest, std::fabs(values[3 * k + c] - expected[k]));
      }
      worst = std::fmax(worst, largest / std::sqrt(norm));
    }
  }
  return worst;
}

void checkEverything(const test::CompiledCode& code, int degree, const std::vector<Vec3d>& probes,
                     const std::vector<Mat3>& rotations, bool doublePrecision) {
  const std::vector<double> colours = someColours(degree, 5);
  const std::vector<double> ones(static_cast<std::size_t>(degree) + 1, 1.0);
  const std::vector<double> cosine = clampedCosineFactors(degree);
  for (const Vec3d& direction : probes) {
    checkBasis(code.basis(direction), direction, degree, doublePrecision);
    checkSum(code.radiance(colours, direction), colours, direction, ones, doublePrecision);
    checkSum(code.irradiance(colours, direction), colours, direction, cosine, doublePrecision);
    if (testing::Test::HasFatalFailure()) return;
  }
  if (degree > kMaximumCodeRotationDegree) return;
  for (const Mat3& rotation : rotations)
    ASSERT_LE(rotationError(code, degree, rotation), doublePrecision ? 3e-14 : 1e-6);
}

struct Case {
  const char* name;
  CodeLanguage language;
  bool doublePrecision;
};
void PrintTo(const Case& one, std::ostream* stream) {
  *stream << one.name;
}

class Values : public testing::TestWithParam<Case> {};

TEST_P(Values, AgreeWithTheLibraryAtEveryDegree) {
  const auto [name, language, doublePrecision] = GetParam();
  SHPRT_NEEDS_COMPILER(language);
  const bool c = language == CodeLanguage::kC;
  std::vector<Vec3d> probes = directions(c ? 1000 : 100);
  if (!doublePrecision)
    for (Vec3d& probe : probes) probe = asFloat(probe);
  for (int degree = 0; degree <= kMaximumCodeDegree; ++degree) {
    // The arithmetic is that of C; what shaders could get wrong shows at few degrees.
    if (!c && degree > 3 && degree != kMaximumCodeRotationDegree && degree != kMaximumCodeDegree) continue;
    SCOPED_TRACE("degree " + std::to_string(degree));
    const test::CompiledCode code(test::requestAll(language, degree, doublePrecision));
    checkEverything(code, degree, probes, hardRotations(!doublePrecision), doublePrecision);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, Values,
                         testing::Values(Case{"c_float", CodeLanguage::kC, false},
                                         Case{"c_double", CodeLanguage::kC, true},
                                         Case{"glsl", CodeLanguage::kGlsl, false},
                                         Case{"hlsl", CodeLanguage::kHlsl, false},
                                         Case{"wgsl", CodeLanguage::kWgsl, false}));

// A constant light of radiance 1 gives irradiance pi on every surface; a light from +y of unit irradiance
// gives 1 on a surface that faces it to the bands there are: sum over l of (2l+1)/4pi A_l.
TEST(Irradiance, MatchesClosedForms) {
  SHPRT_NEEDS_COMPILER(CodeLanguage::kC);
  const int degree = 4;
  const test::CompiledCode code(test::requestAll(CodeLanguage::kC, degree, true));
  std::vector<double> constant(static_cast<std::size_t>(3 * coefficientCount(degree)));
  for (std::size_t c = 0; c < 3; ++c) constant[c] = std::sqrt(4 * pi);
  for (const Vec3d& normal : directions(10)) {
    EXPECT_NEAR(code.irradiance(constant, normal)[1], pi, 1e-14);
    EXPECT_NEAR(code.radiance(constant, normal)[2], 1, 1e-14);
  }
  std::vector<double> beam;
  for (const double value : code.basis({0, 1, 0})) beam.insert(beam.end(), 3, value);
  EXPECT_NEAR(code.irradiance(beam, {0, 1, 0})[0], 1.0 / 4 + 2.0 / 4 + 5.0 / 16 - 9.0 / 96, 1e-14);
}

// H_lm is homogeneous: a direction that is not quite of unit length gives length^l times the value.
TEST(Basis, ScalesWithTheLengthOfTheDirection) {
  SHPRT_NEEDS_COMPILER(CodeLanguage::kC);
  const test::CompiledCode code(test::requestAll(CodeLanguage::kC, kMaximumCodeDegree, true));
  const Vec3d direction = normalize({1, -2, 0.5});
  const std::vector<double> once = code.basis(direction), twice = code.basis(2.0 * direction);
  for (int i = 0; i < coefficientCount(kMaximumCodeDegree); ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_NEAR(std::ldexp(twice[k], -bandOf(i)), once[k], 1e-14);
  }
}

TEST(Basis, AgreesWithTheReference) {
  SHPRT_NEEDS_REFERENCE();
  SHPRT_NEEDS_COMPILER(CodeLanguage::kC);
  const auto reference = test::readReference("sh_eval.json");
  const test::CompiledCode code(test::requestAll(CodeLanguage::kC, kMaximumCodeDegree, true));
  int compared = 0;
  for (const auto& entry : reference["directions"]) {
    const Vec3d direction = normalize(Vec3d{entry["xyz"][0], entry["xyz"][1], entry["xyz"][2]});
    const std::vector<double> values = code.basis(direction);
    for (int i = 0; i < coefficientCount(kMaximumCodeDegree); ++i, ++compared) {
      const auto k = static_cast<std::size_t>(i);
      ASSERT_NEAR(values[k], entry["values"][k].get<double>(), 2e-14 * bandScale(bandOf(i)))
          << entry["name"] << " " << i;
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(Rotation, AgreesWithTheReference) {
  SHPRT_NEEDS_REFERENCE();
  SHPRT_NEEDS_COMPILER(CodeLanguage::kC);
  const auto reference = test::readReference("rotation.json");
  const int degree = kMaximumCodeRotationDegree;
  const test::CompiledCode code(test::requestAll(CodeLanguage::kC, degree, true));
  std::vector<double> colours;
  for (std::size_t i = 0; i < static_cast<std::size_t>(coefficientCount(degree)); ++i)
    for (const double share : {1.0, -0.5, 0.0})
      colours.push_back(share * reference["coefficients"][i].get<double>());
  ASSERT_GT(reference["rotations"].size(), 5u);
  for (const auto& entry : reference["rotations"]) {
    Mat3 matrix;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) matrix.m[i][j] = entry["matrix"][i][j];
    const std::vector<double> values = code.rotate(matrix, colours);
    for (std::size_t i = 0; i < values.size() / 3; ++i) {
      const double expected = entry["rotated"][i];
      ASSERT_NEAR(values[3 * i], expected, 1e-14) << entry["name"] << " " << i;
      ASSERT_NEAR(values[3 * i + 1], -0.5 * expected, 1e-14) << entry["name"] << " " << i;
      ASSERT_EQ(values[3 * i + 2], 0);
    }
  }
}

}  // namespace
}  // namespace shprt
