// Light in other tools' conventions as files: there and back, and one clear line for each mistake.
#include "shprt/coefficients/convention_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/sh/basis.h"
#include "tests/scratch.h"

namespace shprt {
namespace {

using test::scratch;

LightCoefficients makeLight(int degree) {
  LightCoefficients light;
  light.degree = degree;
  for (int i = 0; i < coefficientCount(degree); ++i)
    light.coefficients.push_back({std::cos(i * i), std::sin(3 * i), 1.0 / (i + 1)});
  light.source = "a \"test\"";
  return light;
}

TEST(ConventionFile, ComesBackToRounding) {
  for (const ConventionFacts& facts : allConventions()) {
    const LightCoefficients light = makeLight(facts.maximumDegree > 2 ? 9 : 2);
    writeFile(scratch("light.json"), formatConventionFile(light, facts.convention));
    EXPECT_TRUE(isConventionFile(scratch("light.json")));
    EXPECT_FALSE(isLightFile(scratch("light.json")));
    const LightCoefficients back = readConventionFile(scratch("light.json"));
    EXPECT_EQ(back.degree, light.degree);
    EXPECT_EQ(back.source, light.source);
    ASSERT_EQ(back.coefficients.size(), light.coefficients.size());
    for (std::size_t i = 0; i < light.coefficients.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(back.coefficients[i][c], light.coefficients[i][c], 2e-15) << facts.name << " " << i;
  }
  writeFile(scratch("own.json"), formatLight(makeLight(2)));
  EXPECT_FALSE(isConventionFile(scratch("own.json")));
}

// A file that someone else wrote: an overcast sky of radiance 1 in Unity's SphericalHarmonicsL2, brighter
// towards Unity's +X, which is this project's -X.
TEST(ConventionFile, IsReadFromOtherHands) {
  const std::string zero = "[0,0,0]";
  std::string list = "[1,1,1]";
  for (int i = 1; i < 9; ++i) list += "," + (i == 3 ? std::string("[0.5,0,0]") : zero);
  writeFile(scratch("unity.json"),
            R"({"degree":2,"convention":"unity","version":1,"format":"shprt-convention","coefficients":[)" +
                list + "]}");
  const LightCoefficients light = readConventionFile(scratch("unity.json"));
  const LightStatistics statistics = measureLight(light);
  EXPECT_NEAR(statistics.averageRadiance[0], 1, 1e-15);
  EXPECT_NEAR(statistics.dominantDirection[0], -1, 1e-15);
  // E/pi = 1 + 0.5 x: two thirds of band 1 of the radiance, so that is 0.75 x, whose mean times direction is
  // a third of it.
  EXPECT_NEAR(statistics.directionality[0], 0.25, 1e-15);
  EXPECT_NEAR(statistics.directionality[1], 0, 1e-15);
}

TEST(ConventionFile, RefusesMistakesInOneLineThatNamesTheField) {
  const std::string good = formatConventionFile(makeLight(2), Convention::kUnity),
                    vector = formatConventionFile(makeLight(2), Convention::kL1Vector);
  const auto errorOf = [&](const std::string& text) -> std::string {
    writeFile(scratch("bad.json"), text);
    try {
      readConventionFile(scratch("bad.json"));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const auto edited = [](std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  EXPECT_EQ(errorOf(good), "");
  EXPECT_EQ(errorOf(vector), "");
  const std::size_t entry = vector.find("    [", vector.find("coefficients"));
  std::size_t diagonal = entry;
  for (int i = 0; i < 4; ++i) diagonal = vector.find("    [", diagonal + 1);
  const std::pair<std::string, std::string> cases[] = {
      {errorOf("[]"), "no JSON object"},
      {errorOf(edited(good, "\"shprt-convention\"", "\"other\"")), "format is not"},
      {errorOf(edited(good, "\"version\": 1", "\"version\": 7")), "use a newer shprt"},
      {errorOf(edited(good, "\"unity\"", "\"godot\"")), "convention is wrong"},
      {errorOf(edited(good, "\"degree\": 2", "\"degree\": 3")), "degree is 3, and unity holds 2 to 2"},
      {errorOf(edited(good, "\"unity\"", "\"l1-vector\"")), "has 9 entries where degree 2"},
      {errorOf(edited(good, "    [", "    [7,")), "coefficients[0] does not have three numbers"},
      {errorOf(edited(good, "    [", "    [[],")), "coefficients[0] does not have three numbers"},
      {errorOf(edited(good, "\"coefficients\"", "\"values\"")), "coefficients is missing"},
      {errorOf(std::string(vector).insert(diagonal + 5, "9")), "diagonal of R2"},
      {errorOf(good.substr(0, good.size() / 2)), "JSON"}};
  for (const auto& [message, fragment] : cases) {
    EXPECT_NE(message.find(fragment), std::string::npos) << "'" << message << "' lacks '" << fragment << "'";
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(ConventionFile, IsNotTakenForALightFile) {
  writeFile(scratch("unity.json"), formatConventionFile(makeLight(2), Convention::kUnity));
  try {
    readLight(scratch("unity.json"));
    ADD_FAILURE() << "another tool's coefficients were read as this project's";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("shprt convert unity.json"), std::string::npos) << error.what();
  }
}

TEST(ConventionFile, CountsTheEnergyThatHasNoPlace) {
  LightCoefficients light;
  light.degree = 3;
  light.coefficients.assign(16, {0, 0, 0});
  light.coefficients[0] = {3, 1, 0};
  light.coefficients[8] = {0, 1, 0};
  light.coefficients[12] = {4, 0, 0};
  const std::array<double, 3> share = energyShareAbove(light, 2);
  EXPECT_DOUBLE_EQ(share[0], 16.0 / 25);
  EXPECT_EQ(share[1], 0);
  EXPECT_EQ(share[2], 0);
}

}  // namespace
}  // namespace shprt
