// Light files: exact doubles, figures from definitions, and one clear line for each mistake.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/coefficients/light_coefficients.h"
#include "shprt/sh/basis.h"
#include "tests/scratch.h"

namespace shprt {
namespace {

using test::scratch;

LightCoefficients makeLight(int degree) {
  LightCoefficients light;
  light.degree = degree;
  for (int i = 0; i < coefficientCount(degree); ++i)
    light.coefficients.push_back({std::exp(i % 30), std::sin(i) * 1e-300, -1.0 / (i + 1)});
  light.coefficients[0][1] = -0.0;
  light.source = "a \"test\" \\ with\nmarks";
  light.statisticsJson = R"({"pixels":12})";
  return light;
}

TEST(LightFile, KeepsEveryBit) {
  for (const int degree : {0, 1, 4, 32, 1000}) {
    const LightCoefficients light = makeLight(degree);
    writeLight(scratch("light.json"), light);
    EXPECT_TRUE(isLightFile(scratch("light.json")));
    const LightCoefficients back = readLight(scratch("light.json"));
    EXPECT_EQ(back.degree, degree);
    EXPECT_EQ(back.coefficients, light.coefficients);
    EXPECT_TRUE(std::signbit(back.coefficients[0][1]));
    EXPECT_EQ(back.source, light.source);
    EXPECT_EQ(back.statisticsJson, light.statisticsJson);
  }
}

TEST(LightFile, MeasuresByDefinition) {
  // Radiance 1 everywhere plus 0.5 d.x: average 1, and |L1|/L0 = 0.5/3 (4-pi-normalised: L1 is the mean of
  // radiance times direction).
  LightCoefficients light;
  light.degree = 1;
  light.coefficients.assign(4, {0, 0, 0});
  light.coefficients[0] = {std::sqrt(4 * std::numbers::pi), 0, 0};
  light.coefficients[3][0] = 0.5 * std::sqrt(4 * std::numbers::pi / 3);
  const LightStatistics statistics = measureLight(light);
  EXPECT_NEAR(statistics.averageRadiance[0], 1, 1e-15);
  EXPECT_NEAR(statistics.directionality[0], 0.5 / 3, 1e-15);
  EXPECT_EQ(statistics.directionality[1], 0);
  EXPECT_NEAR(statistics.dominantDirection[0], 1, 1e-15);
  EXPECT_NEAR(statistics.bandEnergy[1][0], 0.25 * 4 * std::numbers::pi / 3, 1e-15);
  // A point light has directionality 1, from wherever it comes.
  std::vector<double> y(4);
  evaluateSh(1, Vec3d{0.6, 0, -0.8}, y);
  for (std::size_t i = 0; i < 4; ++i) light.coefficients[i] = {y[i], y[i], y[i]};
  EXPECT_NEAR(measureLight(light).directionality[2], 1, 1e-15);
  EXPECT_NEAR(measureLight(light).dominantDirection[2], -0.8, 1e-15);
}

TEST(LightFile, EveryTruncationIsRefused) {
  const std::string text = formatLight(makeLight(2));
  const std::size_t last = text.rfind('}');
  for (std::size_t length = 0; length <= last; ++length) {
    std::filesystem::remove(scratch("cut.json"));
    std::ofstream(scratch("cut.json"), std::ios::binary) << text.substr(0, length);
    EXPECT_THROW(readLight(scratch("cut.json")), Error) << length;
  }
}

TEST(LightFile, DeepNestingIsRefused) {
  const std::string text = formatLight(makeLight(1));
  const std::string statistics = "\"statistics\": {\"pixels\":12}";
  ASSERT_NE(text.find(statistics), std::string::npos);
  for (const int depth : {50, 200, 200000}) {
    std::string nested = text;
    nested.replace(text.find(statistics), statistics.size(),
                   "\"statistics\": {\"a\":" + std::string(static_cast<std::size_t>(depth), '[') +
                       std::string(static_cast<std::size_t>(depth), ']') + "}");
    std::ofstream(scratch("deep.json")) << nested;
    if (depth < 100) {
      EXPECT_EQ(readLight(scratch("deep.json")).degree, 1);
    } else {
      EXPECT_THROW(readLight(scratch("deep.json")), Error) << depth;
    }
  }
}

TEST(LightFile, IsNotWrittenWithWhatItCannotHold) {
  std::filesystem::remove(scratch("infinite.json"));
  LightCoefficients light = makeLight(1);
  light.coefficients[2][1] = std::numeric_limits<double>::infinity();
  try {
    writeLight(scratch("infinite.json"), light);
    ADD_FAILURE() << "an infinite coefficient was written";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("coefficient 2 is beyond double"), std::string::npos)
        << error.what();
  }
  light = makeLight(1);
  light.coefficients.pop_back();
  EXPECT_THROW(writeLight(scratch("infinite.json"), light), Error);
  EXPECT_FALSE(std::filesystem::exists(scratch("infinite.json")));
}

TEST(LightFile, RefusesMistakesInOneLineThatNamesTheField) {
  const std::string good = formatLight(makeLight(1));
  const auto errorOf = [&](const std::string& text) -> std::string {
    writeFile(scratch("bad.json"), text);
    try {
      readLight(scratch("bad.json"));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const auto edited = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  EXPECT_EQ(errorOf(good), "");
  const std::pair<std::string, std::string> cases[] = {
      {errorOf(""), "line 1, column 1"},
      {errorOf("{\n  \"format\": \"shprt-light\",\n  oops"), "line 3, column"},
      {errorOf("[1,2]"), "no JSON object"},
      {errorOf(edited("\"shprt-light\"", "\"other\"")), "format is not"},
      {errorOf(edited("\"version\": 1", "\"version\": 2")), "use a newer shprt"},
      {errorOf(edited("\"version\": 1", "\"version\": \"1\"")), "version is no whole number"},
      {errorOf(edited("false", "true")), "basis is another convention"},
      {errorOf(edited("\"degree\": 1", "\"degree\": 2")), "has 4 entries where degree 2 needs 9"},
      {errorOf(edited("\"degree\": 1", "\"degree\": -1")), "degree is outside"},
      {errorOf(edited("\"degree\": 1", "\"degree\": 99999999")), "degree is outside"},
      {errorOf(edited("[1,", "[\"x\",")), "coefficients[0] has an entry"},
      {errorOf(edited("[1,", "[1e999,")), "JSON"},
      {errorOf(edited("[1, ", "[")), "coefficients[0] does not have three numbers"},
      {errorOf(edited("\"basis\"", "\"bases\"")), "basis is missing"},
      {errorOf(edited("\"statistics\": {\"pixels\":12}", "\"statistics\": 12")), "statistics is no object"},
      {errorOf(edited("\"source\"", "\"source\": 1, \"was\"")), "source is no text"}};
  for (const auto& [message, fragment] : cases) {
    EXPECT_NE(message.find(fragment), std::string::npos) << "'" << message << "' lacks '" << fragment << "'";
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace shprt
