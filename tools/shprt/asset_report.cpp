#include "asset_report.h"

#include <fmt/core.h>

#include <map>
#include <utility>
#include <vector>

#include "shprt/coefficients/asset_file.h"
#include "shprt/report/asset_statistics.h"
#include "shprt/report/plan_summary.h"

namespace shprt {
namespace {

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

// The steps that every bake has in the order they are taken, then whatever else took time.
void printSeconds(const Console& console, std::map<std::string, double> seconds) {
  for (const char* step : {"load", "build", "trace"}) {
    if (const auto known = seconds.extract(step))
      console.field(std::string("seconds to ") + step, fmt::format("{:.3f}", known.mapped()));
  }
  for (const auto& [step, spent] : seconds)
    console.field("seconds besides", fmt::format("{} {:.3f}", step, spent));
}

Json describeObjects(const Console& console, const std::vector<ObjectRange>& objects) {
  Json list = Json::array();
  for (const ObjectRange& object : objects) {
    const std::string vertices = object.vertexCount == 0
                                     ? "no vertices"
                                     : fmt::format("vertices {} to {}", object.firstVertex,
                                                   object.firstVertex + object.vertexCount - 1);
    console.field("object", fmt::format("{}, {}, {}", object.name, object.file, vertices));
    list.push_back({{"name", object.name},
                    {"file", object.file},
                    {"firstVertex", object.firstVertex},
                    {"vertexCount", object.vertexCount}});
  }
  return list;
}

// Null for an asset without.
Json describeEmission(const Console& console, const TransferAsset& asset, const AssetStatistics& statistics) {
  if (asset.emission.empty()) return {};
  console.field("emission", fmt::format("{:.5g} to {:.5g}, above 0 at {:.1f}% of the vertices",
                                        statistics.minimumEmission, statistics.maximumEmission,
                                        100 * statistics.emissionShare));
  return {{"minimum", statistics.minimumEmission},
          {"maximum", statistics.maximumEmission},
          {"share", statistics.emissionShare}};
}

// What the bake measured over its scene, and how its rays were spread; null where there is neither.
Json describeSampling(const Console& console, const AssetMetadata& metadata) {
  Json sampling;
  if (metadata.samplingError >= 0) {
    const bool bounded = metadata.samplingErrorBound >= 0;
    console.field(
        "sampling error",
        fmt::format("{:.3g} of the unshadowed transfer, RMS over the scene{}", metadata.samplingError,
                    bounded ? fmt::format("; at most {:.3g} (95%)", metadata.samplingErrorBound) : ""));
    sampling["error"] = metadata.samplingError;
    if (bounded) sampling["errorBound"] = metadata.samplingErrorBound;
  }
  std::string histogram;
  for (const auto& [rays, vertices] : metadata.verticesByRays) {
    histogram += fmt::format("{}{}: {}", histogram.empty() ? "" : ", ", rays, formatCount(vertices));
    sampling["verticesByRays"].push_back({rays, vertices});
  }
  if (!histogram.empty()) console.field("vertices by rays", histogram);
  return sampling;
}

// Of this asset's vertices; null for an asset without the part.
Json describeErrors(const Console& console, const TransferAsset& asset, const AssetStatistics& statistics) {
  if (asset.error.empty()) return {};
  const auto tell = [&](const char* label, const char* of, double error) {
    if (error < 0) return Json();
    console.field(label, fmt::format("{:.3g} of the {}, RMS", error, of));
    return Json(error);
  };
  return {{"transfer", tell("standard error", "unshadowed transfer", statistics.transferError)},
          {"emission", tell("that of emission", "emission", statistics.emissionError)}};
}

}  // namespace

Json describeAsset(const Console& console, const std::string& path) {
  const TransferAsset asset = readAsset(path);
  const std::vector<AssetPart> parts = listAssetParts(path);
  const AssetMetadata& metadata = asset.metadata;
  console.field("asset",
                fmt::format("{}, {}, format version {}, made by shprt {}", path, formatBytes(fileSize(path)),
                            metadata.formatVersion, metadata.toolVersion));
  console.field("model",
                fmt::format("{}, degree {}, {} per vertex{}, seed {}", metadata.model, asset.transfer.degree,
                            countOf(static_cast<std::uint64_t>(metadata.rays), "ray", "rays"),
                            metadata.verticesByRays.empty() ? "" : " on average", metadata.seed));
  console.field("mesh", fmt::format("{}, {}{}", countOf(asset.positions.size(), "vertex", "vertices"),
                                    countOf(asset.triangles.size(), "triangle", "triangles"),
                                    asset.textureCoordinates.empty() ? "" : ", texture coordinates"));
  const Json objects = describeObjects(console, metadata.objects);
  console.field("transfer", asset.transfer.channels == 1 ? "one channel for all colours" : "three channels");
  if (metadata.bounces >= 0) {
    console.field("bounces", fmt::format("{}{}", metadata.bounces,
                                         metadata.tailSummed ? ", and the rest as a geometric series" : ""));
  }
  for (const PlannedEffect& planned : summarisePlan(metadata.plan))
    console.field("plan " + planned.effect, planned.what);
  Json sources = Json::array(), partList = Json::array();
  for (const SourceFile& source : metadata.sources) {
    console.field("source", source.file + "  sha256 " + source.sha256);
    sources.push_back({{"file", source.file}, {"sha256", source.sha256}});
  }
  printSeconds(console, metadata.seconds);
  printCounts(console, metadata.counts);
  for (const std::string& note : metadata.notes) console.field("note", note);
  const Json sampling = describeSampling(console, metadata);
  const AssetStatistics statistics = measureAsset(asset);
  // Under a sky of radiance 1; with bounces it is more than what is seen of it.
  console.field(metadata.model == "interreflected" ? "light received" : "sky seen",
                fmt::format("{:.4f} on average, {:.4f} to {:.4f}", statistics.meanVisibility,
                            statistics.minimumVisibility, statistics.maximumVisibility));
  console.field("coefficients", fmt::format("{:.5g} to {:.5g}", statistics.minimum, statistics.maximum));
  for (std::size_t l = 0; l < statistics.bandEnergy.size(); ++l)
    console.field(fmt::format("energy of band {}", l), fmt::format("{:.4g}", statistics.bandEnergy[l]));
  const Json emission = describeEmission(console, asset, statistics);
  const Json standardError = describeErrors(console, asset, statistics);
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
          {"bounces", metadata.bounces >= 0 ? Json(metadata.bounces) : Json()},
          {"tailSummed", metadata.tailSummed},
          {"vertices", asset.positions.size()},
          {"triangles", asset.triangles.size()},
          {"textureCoordinates", !asset.textureCoordinates.empty()},
          {"objects", objects},
          {"sources", sources},
          {"seconds", metadata.seconds},
          {"counts", metadata.counts},
          {"notes", metadata.notes},
          {"plan", metadata.plan.empty() ? Json() : Json::parse(metadata.plan)},
          {"visibility",
           {{"mean", statistics.meanVisibility},
            {"minimum", statistics.minimumVisibility},
            {"maximum", statistics.maximumVisibility}}},
          {"minimum", statistics.minimum},
          {"maximum", statistics.maximum},
          {"bandEnergy", statistics.bandEnergy},
          {"emission", emission},
          {"sampling", sampling},
          {"standardError", standardError},
          {"parts", partList}};
}

}  // namespace shprt
