// shprt info: everything a file says about itself.
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <system_error>

#include "asset_report.h"
#include "commands.h"
#include "console.h"
#include "file_kind.h"
#include "light_report.h"
#include "mesh_report.h"
#include "options.h"
#include "output.h"
#include "scene_report.h"
#include "shprt/base/error.h"
#include "shprt/image/environment.h"
#include "shprt/light/light_list.h"
#include "shprt/mesh/load_mesh.h"

namespace shprt {
namespace {

constexpr int kListDegree = 4;  // at which a list of lights is looked at

Json describeLight(const Console& console, const LightCoefficients& light, const std::string& heading) {
  console.field("light", heading);
  console.field("degree", std::to_string(light.degree));
  if (!light.source.empty()) console.field("source", light.source);
  printLight(console, light);
  Json figures = {{"degree", light.degree}, {"source", light.source}};
  figures.update(lightStatisticsJson(light));
  return figures;
}

Json describeLightFile(const Console& console, const std::string& path) {
  const LightCoefficients light = readLight(path);
  Json figures = {{"kind", "light"}};
  figures.update(describeLight(console, light, path));
  const Json stored = Json::parse(light.statisticsJson, nullptr, false);
  if (!stored.is_object()) return figures;
  figures["statistics"] = stored;
  // What was measured of the coefficients stands above; the rest tells how the light was made.
  const Json measured = lightStatisticsJson(light);
  for (const auto& [name, value] : stored.items()) {
    if (!measured.contains(name))
      console.field(name, value.dump(-1, ' ', false, Json::error_handler_t::replace));
  }
  return figures;
}

Json describeLightList(const Console& console, const std::string& path) {
  const ProjectedList list = projectLightList(path, kListDegree);
  Json figures = {{"kind", "light list"}};
  figures.update(describeLight(console, list.light, path + ", a list of lights, projected here"));
  for (const std::string& note : list.notes) console.field("note", note);
  figures["notes"] = list.notes;
  return figures;
}

Json describeScene(const Console& console, const std::string& path) {
  const Scene scene = loadScene(path);
  printScene(console, path, scene, {});
  console.field("vertices", formatCount(scene.mesh.positions.size()));
  console.field("triangles", formatCount(scene.mesh.triangles.size()));
  Json objects = Json::array(), materials = Json::array();
  for (const SceneObject& object : scene.objects)
    objects.push_back({{"name", object.name},
                       {"file", object.file},
                       {"role", object.role == Role::kReceiver ? "receiver" : "blocker"}});
  for (const SurfaceMaterial& material : scene.materials) {
    const Vec3f a = material.albedo, e = material.emission;
    std::string text = fmt::format(
        "'{}': {}", material.name,
        material.texture ? std::string("texture") : fmt::format("albedo {:g} {:g} {:g}", a.x, a.y, a.z));
    if (material.emission != Vec3f{}) text += fmt::format(", emission {:g} {:g} {:g}", e.x, e.y, e.z);
    if (material.twoSided) text += ", two-sided";
    console.field("material", text);
    materials.push_back({{"name", material.name},
                         {"albedo", {a.x, a.y, a.z}},
                         {"textured", material.texture.has_value()},
                         {"twoSided", material.twoSided},
                         {"emission", {e.x, e.y, e.z}}});
  }
  return {{"kind", "scene"},
          {"objects", objects},
          {"materials", materials},
          {"vertices", scene.mesh.positions.size()},
          {"triangles", scene.mesh.triangles.size()},
          {"notes", describeLoading(scene)}};
}

Json describeMesh(const Console& console, const std::string& path) {
  const LoadedMesh loaded = loadMesh(path);
  printMesh(console, "mesh", path, loaded.mesh.report);
  console.field("to bake", countOf(loaded.mesh.positions.size(), "vertex", "vertices") + ", " +
                               countOf(loaded.mesh.triangles.size(), "triangle", "triangles"));
  Json materials = Json::array();
  for (const Material& material : loaded.mesh.materials) {
    Json entry = {{"name", material.name}};
    if (material.hasDiffuse) entry["diffuse"] = {material.diffuse.x, material.diffuse.y, material.diffuse.z};
    if (!material.diffuseTexture.empty()) entry["diffuseTexture"] = material.diffuseTexture;
    materials.push_back(entry);
    if (material.name.empty()) continue;
    console.field(
        "material",
        material.name + (material.hasDiffuse ? fmt::format(", Kd {:.4g} {:.4g} {:.4g}", material.diffuse.x,
                                                           material.diffuse.y, material.diffuse.z)
                                             : std::string(", no Kd")));
  }
  return {{"kind", "mesh"},
          {"format", loaded.mesh.report.format},
          {"normalsFromFile", loaded.mesh.report.normalsFromFile},
          {"textureCoordinates", !loaded.mesh.textureCoordinates.empty()},
          {"counts", meshCounts(loaded.mesh)},
          {"materials", materials},
          {"notes", loaded.mesh.report.notes}};
}

Json describeImage(const Console& console, const std::string& path) {
  const LoadedImage loaded = loadImage(path);
  console.field("image", fmt::format("{}, {}, {} x {} pixels", path, loaded.format, loaded.image.width,
                                     loaded.image.height));
  Json figures = {{"kind", "image"},
                  {"format", loaded.format},
                  {"width", loaded.image.width},
                  {"height", loaded.image.height},
                  {"environmentKind", loaded.environmentKind}};
  try {
    const EnvironmentMap map = loadEnvironment(path);
    console.field("as a probe", std::string(layoutName(map.layout)) + ", " + map.layoutReason);
    figures["layout"] = layoutName(map.layout);
    figures["layoutReason"] = map.layoutReason;
  } catch (const Error&) {
    // A picture need not be a probe.
    console.field("as a probe", "no layout fits its shape");
    figures["layout"] = nullptr;
  }
  for (const std::string& note : loaded.notes) console.field("note", note);
  figures["notes"] = loaded.notes;
  return figures;
}

// A folder or pattern of six faces, which is no image by itself.
Json describeFaces(const Console& console, const std::string& path) {
  const EnvironmentMap map = loadEnvironment(path);
  console.field("faces", fmt::format("{}, {}", path, countOf(map.sources.size(), "file", "files")));
  Json files = Json::array();
  for (const std::filesystem::path& source : map.sources) {
    console.field("face", source.string());
    files.push_back(source.string());
  }
  console.field("size", fmt::format("{0} x {0} pixels each", map.image.width));
  for (const std::string& note : map.notes) console.field("note", note);
  return {{"kind", "faces"},
          {"files", files},
          {"faceWidth", map.image.width},
          {"layout", layoutName(map.layout)},
          {"notes", map.notes}};
}

Json describeFile(const Console& console, const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored) || path.find("%s") != std::string::npos)
    return describeFaces(console, path);
  switch (fileKind(path)) {
    case FileKind::kAsset:
      return describeAsset(console, path);
    case FileKind::kLight:
      return describeLightFile(console, path);
    case FileKind::kLightList:
      return describeLightList(console, path);
    case FileKind::kScene:
      return describeScene(console, path);
    case FileKind::kMesh:
      return describeMesh(console, path);
    case FileKind::kImage:
      break;
  }
  return describeImage(console, path);
}

int runInfo(const std::string& path, bool json) {
  const Json figures = describeFile(Console(json, false), path);
  if (!json) return 0;
  Json report = {{"file", path}};
  report.update(figures);
  CommonOptions toStandardOutput;
  toStandardOutput.jsonFile = "-";
  writeFigures(toStandardOutput, report);
  return 0;
}

}  // namespace

void addInfoCommand(CLI::App& app, Command& chosen) {
  struct InfoOptions {
    std::string path;
    bool json = false;
  };
  const auto options = std::make_shared<InfoOptions>();
  CLI::App& sub =
      *app.add_subcommand("info", "Say what a file is: asset, light file, list of lights, image or mesh");
  sub.add_option("FILE", options->path, "The file")->required();
  sub.add_flag("--json", options->json, "As JSON on standard output");
  sub.footer(
      "Examples:\n"
      "  shprt info bunny.prt.exr\n"
      "  shprt info sky.hdr --json");
  sub.callback([options, &chosen] { chosen = [options] { return runInfo(options->path, options->json); }; });
}

}  // namespace shprt
