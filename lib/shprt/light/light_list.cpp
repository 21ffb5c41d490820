// Lists of lights: each entry is checked field by field, projected, and added up.

#include "shprt/light/light_list.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/base/json_input.h"
#include "shprt/coefficients/asset_file.h"
#include "shprt/image/environment.h"
#include "shprt/light/project_probe.h"
#include "shprt/sh/basis.h"
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

// What make() returns; what is wrong with the field it reads is said with the field's place in the list.
template <typename Make>
auto blame(const JsonObject& entry, const char* field, const Make& make) {
  try {
    return make();
  } catch (const Error& error) {
    entry.fail(field, std::string("is wrong: ") + error.what());
  }
}

// The coefficients of an image; what was found and done on the way becomes notes and sources.
LightCoefficients projectImage(const std::filesystem::path& file, std::optional<EnvironmentLayout> layout,
                               int degree, bool strict, ProjectedList& list) {
  const EnvironmentMap map = loadEnvironment(file, layout);
  const ProbeProjection projection = projectProbe(map, {.degree = degree, .strict = strict});
  list.sources.insert(list.sources.end(), map.sources.begin(), map.sources.end());
  const auto note = [&](const std::string& text) {
    list.notes.push_back(file.filename().string() + ": " + text);
  };
  note(std::string("layout ") + layoutName(map.layout) + " (" + map.layoutReason + ")");
  for (const std::string& text : map.notes) note(text);
  if (projection.nonFinitePixels > 0)
    note(std::to_string(projection.nonFinitePixels) + " pixels that are not finite left out");
  if (projection.negativePixels > 0)
    note(std::to_string(projection.negativePixels) + " negative pixels, used as they are");
  return projection.light;
}

LightCoefficients projectProbeEntry(const JsonObject& entry, const std::filesystem::path& folder, int degree,
                                    bool strict, ProjectedList& list) {
  entry.allowOnly({"type", "file", "scale", "rotate", "layout"});
  const std::filesystem::path file = folder / entry.text("file");
  const bool isPattern = file.string().find("%s") != std::string::npos;  // of six faces
  if (!isPattern && !std::filesystem::exists(file))
    entry.fail("file", "names " + file.string() + ", which does not exist",
               "paths are relative to the list's folder");
  if (std::filesystem::exists(file) && !std::filesystem::is_regular_file(file) &&
      !std::filesystem::is_directory(file))
    entry.fail("file", "names " + file.string() + ", a pipe or device", "save its content to a file first");
  if (isAssetFile(file))
    entry.fail("file", "names " + file.string() + ", a baked asset", "give an image or a light file");
  const double scale = entry.has("scale") ? entry.number("scale") : 1;
  if (scale < 0) entry.fail("scale", "is negative", "light cannot be negative");
  Mat3 rotation;
  if (entry.has("rotate")) {
    const std::string specification = entry.text("rotate");
    rotation = blame(entry, "rotate", [&] { return parseRotation(specification); });
    if (specification.starts_with('@')) list.sources.push_back(specification.substr(1));
  }
  std::optional<EnvironmentLayout> layout;
  if (entry.has("layout") && entry.text("layout") != "auto")
    layout = blame(entry, "layout", [&] { return parseLayout(entry.text("layout")); });
  const bool isImage = !outlineJson(file).object;
  if (layout && !isImage) entry.fail("layout", "is given, but the file is no image", "leave it out");
  if (isImage && degree > kMaximumBakeDegree)
    entry.fail("file", "names an image, and the degree asked for is " + std::to_string(degree),
               "images are projected to degree " + std::to_string(kMaximumBakeDegree) + " at most");
  LightCoefficients light = blame(entry, "file", [&] {
    if (isImage) return projectImage(file, layout, degree, strict, list);
    list.sources.push_back(file);
    return readLight(file);
  });
  if (entry.has("rotate")) light = rotateLight(light, rotation);
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
  return outlineJson(path).hasLights;
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
    // Finite numbers can overflow together.
    for (const auto& coefficient : list.light.coefficients)
      for (const double value : coefficient)
        if (!std::isfinite(value)) entry.fail("", "is too bright to be added up", "make it darker");
  }
  list.light = withDegree(list.light, std::min(list.light.degree, degree));
  list.light.source = path.string();
  return list;
}

}  // namespace shprt
