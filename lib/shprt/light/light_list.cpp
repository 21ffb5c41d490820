#include "shprt/light/light_list.h"

#include <algorithm>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/coefficients/asset_file.h"
#include "shprt/coefficients/json_input.h"
#include "shprt/image/environment.h"
#include "shprt/light/project_probe.h"
#include "shprt/sh/rotation.h"

namespace shprt {
namespace {

std::array<double, 3> nonNegative(const JsonObject& entry, const char* field) {
  const std::array<double, 3> values = entry.triple(field);
  for (const double value : values) {
    if (value < 0) entry.fail(field, "has a negative entry", "light cannot be negative");
  }
  return values;
}

LightCoefficients projectProbeEntry(const JsonObject& entry, const std::filesystem::path& folder, int degree,
                                    bool strict, ProjectedList& list) {
  entry.allowOnly({"type", "file", "scale", "rotate", "layout"});
  const std::filesystem::path file = folder / entry.text("file");
  if (!std::filesystem::exists(file))
    entry.fail("file", "names " + file.string() + ", which does not exist",
               "paths are relative to the list's folder");
  const double scale = entry.has("scale") ? entry.number("scale") : 1;
  if (scale < 0) entry.fail("scale", "is negative", "light cannot be negative");
  if (!std::filesystem::is_regular_file(file) && !std::filesystem::is_directory(file)) {
    entry.fail("file", "names " + file.string() + ", a pipe or device", "save its content to a file first");
  }
  if (isAssetFile(file))
    entry.fail("file", "names " + file.string() + ", a baked asset", "give an image or a light file");
  LightCoefficients light;
  if (isLightFile(file)) {
    light = readLight(file);
    list.sources.push_back(file);
  } else {
    std::optional<EnvironmentLayout> layout;
    if (entry.has("layout") && entry.text("layout") != "auto") {
      try {
        layout = parseLayout(entry.text("layout"));
      } catch (const Error& problem) {
        entry.fail("layout", std::string("is wrong: ") + problem.what());
      }
    }
    const EnvironmentMap map = loadEnvironment(file, layout);
    const ProbeProjection projection = projectProbe(map, {.degree = degree, .strict = strict});
    light = projection.light;
    list.sources.insert(list.sources.end(), map.sources.begin(), map.sources.end());
    const std::string name = file.filename().string();
    list.notes.push_back(name + ": layout " + layoutName(map.layout) + " (" + map.layoutReason + ")");
    for (const std::string& note : map.notes) list.notes.push_back(name + ": " + note);
    if (projection.nonFinitePixels)
      list.notes.push_back(name + ": " + std::to_string(projection.nonFinitePixels) +
                           " pixels that are not finite left out");
    if (projection.negativePixels)
      list.notes.push_back(name + ": " + std::to_string(projection.negativePixels) +
                           " negative pixels, used as they are");
  }
  if (entry.has("rotate")) {
    try {
      light = rotateLight(light, parseRotation(entry.text("rotate")));
    } catch (const Error& problem) {
      entry.fail("rotate", std::string("is wrong: ") + problem.what());
    }
  }
  return scaleLight(light, scale);
}

LightCoefficients projectEntry(const JsonObject& entry, const std::filesystem::path& folder, int degree,
                               bool strict, ProjectedList& list) {
  const std::string type = entry.text("type");
  if (type == "directional") {
    entry.allowOnly({"type", "direction", "irradiance"});
    const auto [x, y, z] = entry.triple("direction");
    if (x == 0 && y == 0 && z == 0)
      entry.fail("direction", "is zero", "give a vector that points towards the light");
    return projectDirectional({x, y, z}, nonNegative(entry, "irradiance"), degree);
  }
  if (type == "constant") {
    entry.allowOnly({"type", "radiance"});
    return projectConstant(nonNegative(entry, "radiance"), degree);
  }
  if (type == "probe") return projectProbeEntry(entry, folder, degree, strict, list);
  entry.fail("type", "'" + type.substr(0, 40) + "' is not known", "use directional, constant or probe");
}

}  // namespace

bool isLightList(const std::filesystem::path& path) {
  const std::string bytes = readFirstBytes(path, std::size_t{1} << 16);
  const std::size_t brace = bytes.find_first_not_of(" \t\r\n");
  return brace != std::string::npos && bytes[brace] == '{' && bytes.find("\"lights\"") != std::string::npos;
}

ProjectedList projectLightList(const std::filesystem::path& path, int degree, bool strict) {
  const nlohmann::json content = readJsonObject(path);
  const JsonObject file(path.string(), "", content);
  file.allowOnly({"lights"});
  const nlohmann::json& lights = file.field("lights");
  if (!lights.is_array() || lights.empty()) file.fail("lights", "is no list of lights", "write [{...}, ...]");
  ProjectedList list;
  list.sources.push_back(path);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const JsonObject entry(path.string(), "lights[" + std::to_string(i) + "]", lights[i]);
    const LightCoefficients light = projectEntry(entry, path.parent_path(), degree, strict, list);
    if (light.degree < degree && !(i > 0 && list.light.degree <= light.degree)) {
      list.notes.push_back("lights[" + std::to_string(i) + "] holds only degree " +
                           std::to_string(light.degree) + "; the sum has no more");
    }
    list.light = i == 0 ? light : addLights(list.light, light);
  }
  list.light = withDegree(list.light, std::min(list.light.degree, degree));
  list.light.source = path.string();
  return list;
}

}  // namespace shprt
