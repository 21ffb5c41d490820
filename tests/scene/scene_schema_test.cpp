// docs/scene.schema.json and the loader know the same fields. What the loader knows, it says when it meets a
// field that it does not know.
#include <set>

#include "shprt/base/json_input.h"
#include "tests/scene/scene_files.h"

namespace shprt {
namespace {

using Names = std::set<std::string>;

Names knownToLoader(const std::string& json) {
  const std::string error = test::errorOf(json), mark = "known fields: ";
  Names names;
  std::size_t at = error.find(mark);
  EXPECT_NE(at, std::string::npos) << error;
  for (at += mark.size(); at < error.size(); at += 2) {
    const std::size_t end = std::min(error.find(", ", at), error.size());
    names.insert(error.substr(at, end - at));
    at = end;
  }
  return names;
}

Names namesOf(const nlohmann::json& schema) {
  EXPECT_EQ(schema.at("additionalProperties"), false);
  Names names;
  for (const auto& [name, value] : schema.at("properties").items()) names.insert(name);
  return names;
}

TEST(SceneSchema, KnowsTheFieldsOfTheLoader) {
  const nlohmann::json schema = readJsonObject(SHPRT_SOURCE_DIR "/docs/scene.schema.json");
  const nlohmann::json& parts = schema.at("$defs");
  test::writeScratch("m.obj", test::triangleObj());
  const std::string unknown = R"({"?": 1})";
  EXPECT_EQ(namesOf(schema), knownToLoader(unknown));
  EXPECT_EQ(namesOf(parts.at("object")), knownToLoader(R"({"objects": [{"?": 1}]})"));
  EXPECT_EQ(namesOf(parts.at("transform")), knownToLoader(test::oneObject("\"transform\": " + unknown)));
  EXPECT_EQ(namesOf(parts.at("rotate")),
            knownToLoader(test::oneObject("\"transform\": {\"rotate\": " + unknown + "}")));
  EXPECT_EQ(namesOf(parts.at("material")), knownToLoader(test::oneObject("\"material\": " + unknown)));
  for (const std::string part : {"glossy", "translucent"})
    EXPECT_EQ(namesOf(parts.at(part)),
              knownToLoader(test::oneObject("\"material\": {\"" + part + "\": " + unknown + "}")));
}

}  // namespace
}  // namespace shprt
