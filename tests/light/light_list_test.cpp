// Lists of lights, and each mistake one can make in them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/image/image.h"
#include "shprt/light/light_list.h"
#include "shprt/light/project_probe.h"
#include "shprt/sh/basis.h"
#include "tests/scratch.h"

namespace shprt {
namespace {

using std::numbers::pi;

using test::scratch;

TEST(LightList, AddsItsLights) {
  writeFile(scratch("a.json"), formatLight(projectConstant({1, 1, 1}, 4)));
  writeFile(scratch("lights.json"),
            R"({"lights":[{"type":"directional","direction":[0,1,0],"irradiance":[1,2,3]},
    {"type":"constant","radiance":[0.5,0.5,0.5]},{"type":"probe","file":"a.json","scale":2,"rotate":"axis:0,1,0,30"}]})");
  EXPECT_TRUE(isLightList(scratch("lights.json")));
  EXPECT_FALSE(isLightList(scratch("a.json")));
  const LightCoefficients light = projectLightList(scratch("lights.json"), 3).light;
  EXPECT_EQ(light.degree, 3);
  std::vector<double> y(16);
  evaluateSh(3, Vec3d{0, 1, 0}, y);
  EXPECT_NEAR(light.coefficients[0][1], 2 * y[0] + 2.5 * std::sqrt(4 * pi), 1e-13);
  EXPECT_NEAR(light.coefficients[1][2], 3 * y[1], 1e-13);
}

TEST(LightList, ProjectsImagesAndCountsWhatItMends) {
  Image image{8, 4, std::vector<Vec3f>(32, Vec3f{1, 1, 1})};
  image.at(1, 1) = {NAN, 1, 1};
  saveImage(scratch("sky.exr"), image);
  writeFile(scratch("lights.json"),
            R"({"lights":[{"type":"probe","file":"sky.exr","layout":"latlong","scale":3}]})");
  const ProjectedList list = projectLightList(scratch("lights.json"), 2);
  EXPECT_NEAR(list.light.coefficients[0][1], 3 * std::sqrt(4 * pi), 1e-12);
  ASSERT_EQ(list.notes.size(), 2u);
  EXPECT_NE(list.notes[0].find("latlong"), std::string::npos);
  EXPECT_NE(list.notes[1].find("1 pixel"), std::string::npos);
  EXPECT_EQ(list.sources.size(), 2u);
  EXPECT_THROW(projectLightList(scratch("lights.json"), 2, true), Error);
}

TEST(LightList, ALightOfLowerDegreeIsNoted) {
  writeFile(scratch("low.json"), formatLight(projectConstant({1, 1, 1}, 1)));
  writeFile(scratch("lights.json"),
            R"({"lights":[{"type":"constant","radiance":[1,1,1]},{"type":"probe","file":"low.json"}]})");
  const ProjectedList list = projectLightList(scratch("lights.json"), 3);
  EXPECT_EQ(list.light.degree, 1);
  ASSERT_EQ(list.notes.size(), 1u);
  EXPECT_NE(list.notes[0].find("lights[1] holds only degree 1"), std::string::npos);
}

TEST(LightList, RefusesEachMistakeInOneLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"{", "not valid JSON"},
      {R"({"lights":[]})", "no list of lights"},
      {R"({"lights":[3]})", "lights[0] is no object"},
      {R"({"lamps":[]})", "lamps is not known"},
      {R"({"lights":[{"type":"sun"}]})", "lights[0].type 'sun' is not known"},
      {R"({"lights":[{"direction":[0,1,0]}]})", "lights[0].type is missing"},
      {R"({"lights":[{"type":"directional","direction":[0,1],"irradiance":[1,1,1]}]})",
       "lights[0].direction does not have three numbers"},
      {R"({"lights":[{"type":"directional","direction":[0,0,0],"irradiance":[1,1,1]}]})",
       "lights[0].direction is zero"},
      {R"({"lights":[{"type":"directional","direction":[0,1,0],"irradiance":[1,-1,1]}]})",
       "lights[0].irradiance has a negative"},
      {R"({"lights":[{"type":"directional","direction":[0,1,0],"radiance":[1,1,1]}]})",
       "lights[0].radiance is not known"},
      {R"({"lights":[{"type":"constant","radiance":[1,1,1]},{"type":"constant"}]})",
       "lights[1].radiance is missing"},
      {R"({"lights":[{"type":"constant","radiance":["1",1,1]}]})", "lights[0].radiance has an entry"},
      {R"({"lights":[{"type":"probe","file":"nowhere.exr"}]})", "lights[0].file names"},
      {R"({"lights":[{"type":"probe","file":"a.json","scale":-1}]})", "lights[0].scale is negative"},
      {R"({"lights":[{"type":"probe","file":"a.json","scale":1e999}]})", "beyond the range"},
      {R"({"lights":[{"type":"constant","radiance":[1,NaN,1]}]})", "line 1, column"},
      {R"({"lights":[{"type":"constant","radiance":[1e300,1,1]},{"type":"constant","radiance":[1e308,1e308,1e308]}]})",
       "lights[1] is too bright"},
      {R"({"lights":[{"type":"constant","radiance":[1,1,1],"note":"x"}]})", "lights[0].note is not known"},
      {R"({"lights":[{"type":"probe","file":"broken.exr"}]})", "lights[0].file is wrong"},
      {R"({"lights":[{"type":"probe","file":"a.json","layout":"round"}]})", "lights[0].layout is wrong"},
      {R"({"lights":[{"type":7}]})", "lights[0].type is no text"},
      {R"({"lights":[{"type":"probe","file":"a.json","rotate":"turn"}]})", "lights[0].rotate is wrong"}};
  writeFile(scratch("a.json"), formatLight(projectConstant({1, 1, 1}, 4)));
  writeFile(scratch("broken.exr"), "no picture");
  for (const auto& [text, fragment] : cases) {
    writeFile(scratch("bad.json"), text);
    try {
      projectLightList(scratch("bad.json"), 2);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).rfind(scratch("bad.json"), 0), 0u) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace shprt
