// shprt info: everything a file says about itself.
#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <memory>
#include <system_error>
#include <utility>

#include "commands.h"
#include "console.h"
#include "file_kind.h"
#include "light_report.h"
#include "mesh_report.h"
#include "options.h"
#include "output.h"
#include "shprt/base/error.h"
#include "shprt/coefficients/asset_file.h"
#include "shprt/image/environment.h"
#include "shprt/light/light_list.h"
#include "shprt/mesh/load_mesh.h"
#include "shprt/report/asset_statistics.h"

namespace shprt {
namespace {

constexpr int kListDegree = 4;  // at which a list of lights is looked at

// What the loader and the bake counted, in words and where there is anything to tell.
void printCounts(const Console& console, const std::map<std::string, std::uint64_t>& counts) {
  constexpr std::pair<const char*, const char*> kWords[] = {{"sourceVertices", "vertices in source"},
                                                            {"sourceFaces", "faces in source"},
                                                            {"badIndexFaces", "bad index, left out"},
                                                            {"nonFiniteFaces", "NaN corner, left out"},
                                                            {"shortFaces", "short faces, left out"},
                                                            {"zeroAreaTriangles", "no area, left out"},
                                                            {"nonFiniteVertices", "NaN vertices"},
                                                            {"unreferencedVertices", "unused vertices"},
                                                            {"generatedNormals", "normals computed"},
                                                            {"samplePoints", "points baked"},
                                                            {"rays", "rays"},
                                                            {"fullyVisible", "see everything"},
                                                            {"fullyHidden", "see nothing"}};
  for (const auto& [name, words] : kWords) {
    const auto count = counts.find(name);
    if (count != counts.end() && count->second > 0) console.field(words, formatCount(count->second));
  }
}

Json describeAsset(const Console& console, const std::string& path) {
  const TransferAsset asset = readAsset(path);
  const std::vector<AssetPart> parts = listAssetParts(path);
  const AssetMetadata& metadata = asset.metadata;
  console.field("asset",
                fmt::format("{}, {}, format version {}, made by shprt {}", path, formatBytes(fileSize(path)),
                            metadata.formatVersion, metadata.toolVersion));
  console.field(
      "model", fmt::format("{}, degree {}, {} per vertex, seed {}", metadata.model, asset.transfer.degree,
                           countOf(static_cast<std::uint64_t>(metadata.rays), "ray", "rays"), metadata.seed));
  console.field("mesh", fmt::format("{}, {}{}", countOf(asset.positions.size(), "vertex", "vertices"),
                                    countOf(asset.triangles.size(), "triangle", "triangles"),
                                    asset.textureCoordinates.empty() ? "" : ", texture coordinates"));
  console.field("transfer", asset.transfer.channels == 1 ? "one channel for all colours" : "three channels");
  Json sources = Json::array(), partList = Json::array();
  for (const SourceFile& source : metadata.sources) {
    console.field("source", source.file + "  sha256 " + source.sha256);
    sources.push_back({{"file", source.file}, {"sha256", source.sha256}});
  }
  for (const char* step : {"load", "build", "trace"}) {
    if (const auto seconds = metadata.seconds.find(step); seconds != metadata.seconds.end())
      console.field(std::string("seconds to ") + step, fmt::format("{:.3f}", seconds->second));
  }
  printCounts(console, metadata.counts);
  for (const std::string& note : metadata.notes) console.field("note", note);
  const AssetStatistics statistics = measureAsset(asset);
  console.field("sky seen", fmt::format("{:.4f} on average, {:.4f} to {:.4f}", statistics.meanVisibility,
                                        statistics.minimumVisibility, statistics.maximumVisibility));
  console.field("coefficients", fmt::format("{:.5g} to {:.5g}", statistics.minimum, statistics.maximum));
  for (std::size_t l = 0; l < statistics.bandEnergy.size(); ++l)
    console.field(fmt::format("energy of band {}", l), fmt::format("{:.4g}", statistics.bandEnergy[l]));
  for (const AssetPart& part : parts) {
    console.field("part " + part.name,
                  fmt::format("{} x {}, {} {}, {}, {}", part.width, part.height, part.channels,
                              part.pixelType, part.type, part.compression));
    partList.push_back({{"name", part.name},
                        {"type", part.type},
                        {"pixelType", part.pixelType},
                        {"compression", part.compression},
                        {"channels", part.channels},
                        {"width", part.width},
                        {"height", part.height}});
  }
  return {{"kind", "asset"},
          {"bytes", fileSize(path)},
          {"formatVersion", metadata.formatVersion},
          {"toolVersion", metadata.toolVersion},
          {"model", metadata.model},
          {"degree", asset.transfer.degree},
          {"channels", asset.transfer.channels},
          {"rays", metadata.rays},
          {"seed", metadata.seed},
          {"vertices", asset.positions.size()},
          {"triangles", asset.triangles.size()},
          {"textureCoordinates", !asset.textureCoordinates.empty()},
          {"sources", sources},
          {"seconds", metadata.seconds},
          {"counts", metadata.counts},
          {"notes", metadata.notes},
          {"visibility",
           {{"mean", statistics.meanVisibility},
            {"minimum", statistics.minimumVisibility},
            {"maximum", statistics.maximumVisibility}}},
          {"minimum", statistics.minimum},
          {"maximum", statistics.maximum},
          {"bandEnergy", statistics.bandEnergy},
          {"parts", partList}};
}

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
