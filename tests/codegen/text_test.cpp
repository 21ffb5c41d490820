// The text of generated code: constants, selection, the opening comment.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <regex>

#include "shprt/codegen/dialect.h"
#include "shprt/codegen/generate.h"
#include "shprt/codegen/solid_harmonic.h"
#include "tests/codegen/compiled_code.h"

namespace shprt {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// y_4,0 = (3/16) sqrt(1/pi) (35 z^4 - 30 z^2 + 3) is 8 z^4 - 24 z^2 s + 3 s^2 in the same units, because z^2
// = 1 - s; y_3,1 = sqrt(21/32pi) x (4 z^2 - s); y_5,5 = sqrt(693/512pi) Re (x + iy)^5.
TEST(SolidHarmonic, MatchesClosedForms) {
  using std::numbers::pi;
  const std::vector<double> band4 = solidHarmonic(4, 0);
  ASSERT_EQ(band4.size(), 3u);
  const double unit = 3.0 / 16 / std::sqrt(pi);
  EXPECT_NEAR(band4[0] / unit, 8, 1e-14);
  EXPECT_NEAR(band4[1] / unit, -24, 4e-14);
  EXPECT_NEAR(band4[2] / unit, 3, 1e-14);
  const std::vector<double> band3 = solidHarmonic(3, -1);
  ASSERT_EQ(band3.size(), 2u);
  EXPECT_NEAR(band3[0], 4 * std::sqrt(21 / (32 * pi)), 1e-15);
  EXPECT_NEAR(band3[1], -std::sqrt(21 / (32 * pi)), 1e-15);
  ASSERT_EQ(solidHarmonic(5, 5).size(), 1u);
  EXPECT_NEAR(solidHarmonic(5, 5)[0], std::sqrt(693 / (512 * pi)), 1e-15);
}

TEST(ShortestDecimal, ReadsBackAsTheSameNumber) {
  for (int l = 0; l <= 20; ++l)
    for (int m = 0; m <= l; ++m)
      for (const double coefficient : solidHarmonic(l, m)) {
        const std::string single = shortestDecimal(coefficient, false);
        EXPECT_EQ(std::strtof(single.c_str(), nullptr), static_cast<float>(coefficient));
        // A compiler may read it as a double first.
        EXPECT_EQ(static_cast<float>(std::strtod(single.c_str(), nullptr)), static_cast<float>(coefficient));
        EXPECT_LE(single.size(), 12u) << single;
        EXPECT_EQ(std::strtod(shortestDecimal(coefficient, true).c_str(), nullptr), coefficient);
      }
  EXPECT_EQ(shortestDecimal(2, false), "2.0");
  EXPECT_EQ(shortestDecimal(0.1f, false), "0.1");
  EXPECT_EQ(shortestDecimal(0.1, true), "0.1");
  EXPECT_EQ(shortestDecimal(1e-20, false), "1e-20");
}

TEST(Statement, BreaksLongSumsBetweenTerms) {
  std::string sum = "total = first";
  for (int i = 0; i < 12; ++i) sum += " + (a - b) * coefficients[" + std::to_string(i) + "]";
  const std::string lines = statement(sum + ";");
  EXPECT_EQ(std::regex_replace(lines, std::regex("\n +"), " "), "  " + sum + ";\n");
  EXPECT_GT(std::count(lines.begin(), lines.end(), '\n'), 3);
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = lines.find('\n', begin);
    EXPECT_LE(end - begin, 100u);
    begin = end + 1;
  }
}

TEST(GenerateCode, PrintsOnlyWhatWasAskedFor) {
  for (const CodeLanguage language :
       {CodeLanguage::kGlsl, CodeLanguage::kHlsl, CodeLanguage::kWgsl, CodeLanguage::kC})
    for (int choice = 1; choice < 16; ++choice) {
      CodeRequest request = test::requestAll(language, 3);
      request.functions = {(choice & 1) != 0, (choice & 2) != 0, (choice & 4) != 0, (choice & 8) != 0};
      const std::string code = generateCode(request);
      EXPECT_EQ(contains(code, "shEvaluateBasis("), request.functions.basis);
      EXPECT_EQ(contains(code, "shRadiance("), request.functions.radiance);
      EXPECT_EQ(contains(code, "shIrradiance("), request.functions.irradiance);
      EXPECT_EQ(contains(code, "shRotate("), request.functions.rotation);
      EXPECT_EQ(contains(code, "shAddBand3("), request.functions.rotation);
      EXPECT_EQ(code, generateCode(request));
    }
}

// Above band 1 the clamped cosine has even bands only.
TEST(GenerateCode, IrradianceLeavesOutBandsThatVanish) {
  CodeRequest request = test::requestAll(CodeLanguage::kGlsl, 3);
  request.functions = {false, false, true, false};
  const std::string code = generateCode(request);
  EXPECT_TRUE(contains(code, "coefficients[8];"));
  EXPECT_FALSE(contains(code, "coefficients[9]"));
  EXPECT_FALSE(contains(code, "re3"));
}

TEST(GenerateCode, HasNoTrigonometryDivisionOrBranch) {
  for (const CodeLanguage language :
       {CodeLanguage::kGlsl, CodeLanguage::kHlsl, CodeLanguage::kWgsl, CodeLanguage::kC}) {
    const std::string code = generateCode(test::requestAll(language, kMaximumCodeRotationDegree));
    const std::string body = std::regex_replace(code, std::regex("(//|#)[^\n]*"), "");
    EXPECT_FALSE(std::regex_search(body, std::regex(R"(/|\b(sin|cos|sqrt|pow|if|atan2?|acos)\b)")));
  }
}

TEST(GenerateCode, TheCommandStaysInItsComment) {
  CodeRequest request = test::requestAll(CodeLanguage::kC, 1);
  request.command = "shprt codegen --light 'a\nint evil;\r'";
  EXPECT_TRUE(contains(generateCode(request), "//   shprt codegen --light 'a?int evil;?'\n"));
}

TEST(GenerateCode, LightBecomesAConstant) {
  CodeRequest request = test::requestAll(CodeLanguage::kGlsl, 0);
  request.light = {{0.1, -2, 1e-12}};
  EXPECT_TRUE(
      contains(generateCode(request), "const vec3 shLight[1] = vec3[1](\n  vec3(0.1, -2.0, 1e-12)\n);"));
  request.language = CodeLanguage::kC;
  EXPECT_TRUE(
      contains(generateCode(request), "static const float shLight[3] = {\n  0.1f, -2.0f, 1e-12f,\n};"));
  request.language = CodeLanguage::kWgsl;
  EXPECT_TRUE(contains(generateCode(request),
                       "const shLight = array<vec3<f32>, 1>(\n  vec3<f32>(0.1, -2.0, 1e-12)\n);"));
  request.language = CodeLanguage::kHlsl;
  EXPECT_TRUE(
      contains(generateCode(request), "static const float3 shLight[1] = {\n  float3(0.1, -2.0, 1e-12)\n};"));
}

}  // namespace
}  // namespace shprt
