#include "shprt/coefficients/asset_metadata.h"

#include <cstdint>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>

#include "shprt/base/error.h"
#include "shprt/base/json_input.h"
#include "shprt/coefficients/asset_layout.h"
#include "shprt/coefficients/basis_name.h"
#include "shprt/coefficients/object_ranges.h"

namespace shprt {
namespace {

int smallInteger(const JsonObject& json, const char* field) {
  const std::int64_t value = json.integer(field);
  if (value < 0 || value > std::numeric_limits<int>::max()) json.fail(field, "is out of range");
  return static_cast<int>(value);
}

std::string compact(const nlohmann::json& plan) {
  return plan.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// The plan is read as the one entry of a list, so that it is nested as deep here as within the metadata, and
// readers do not refuse what was written.
nlohmann::ordered_json planObject(const std::filesystem::path& path, const std::string& plan) {
  try {
    const nlohmann::json list = parseJson("[" + plan + "]");
    if (list.size() == 1 && list[0].is_object() && compact(list[0]).size() <= asset_layout::kMaximumPlanBytes)
      return list[0];
  } catch (const std::exception&) {
    // Told below, as whatever else is no object.
  }
  throw Error(path.string(), "the plan to write is no JSON object of at most 1 MB");
}

void parseObjects(const std::filesystem::path& path, const nlohmann::json& list, AssetMetadata& metadata) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const JsonObject object(path.string(), "shprtMetadata.objects[" + std::to_string(i) + "]", list[i]);
    metadata.objects.push_back({object.text("name"), object.text("file"), object.natural("firstVertex"),
                                object.natural("vertexCount")});
  }
}

double notNegative(const JsonObject& json, const char* field) {
  const double value = json.number(field);
  if (value < 0) json.fail(field, "is negative");
  return value;
}

nlohmann::ordered_json samplingObject(const AssetMetadata& metadata) {
  nlohmann::ordered_json sampling;
  if (metadata.samplingError >= 0) sampling["error"] = metadata.samplingError;
  if (metadata.samplingErrorBound >= 0) sampling["errorBound"] = metadata.samplingErrorBound;
  for (const auto& [rays, vertices] : metadata.verticesByRays)
    sampling["verticesByRays"].push_back({rays, vertices});
  return sampling;
}

void parseSampling(const JsonObject& sampling, AssetMetadata& metadata) {
  if (sampling.has("error")) metadata.samplingError = notNegative(sampling, "error");
  if (sampling.has("errorBound")) metadata.samplingErrorBound = notNegative(sampling, "errorBound");
  if (!sampling.has("verticesByRays")) return;
  std::int64_t previous = -1;
  for (const nlohmann::json& entry : sampling.list("verticesByRays")) {
    if (!entry.is_array() || entry.size() != 2 || !entry[0].is_number_unsigned() ||
        !entry[1].is_number_unsigned())
      sampling.fail("verticesByRays", "has an entry that is no pair of rays and vertices");
    const auto rays = entry[0].get<std::uint64_t>();
    if (rays > static_cast<std::uint64_t>(std::numeric_limits<int>::max()) ||
        static_cast<std::int64_t>(rays) <= previous)
      sampling.fail("verticesByRays", "has rays that are out of range or do not increase");
    previous = static_cast<std::int64_t>(rays);
    metadata.verticesByRays[static_cast<int>(rays)] = entry[1].get<std::uint64_t>();
  }
}

// What scenes brought: assets of plain meshes, and those made before, have none of it.
void parseSceneFields(const std::filesystem::path& path, const JsonObject& json, AssetMetadata& metadata) {
  if (json.has("objects")) parseObjects(path, json.list("objects"), metadata);
  if (json.has("bounces")) metadata.bounces = smallInteger(json, "bounces");
  if (json.has("tailSummed")) {
    const nlohmann::json& tailSummed = json.field("tailSummed");
    if (!tailSummed.is_boolean()) json.fail("tailSummed", "is neither true nor false");
    metadata.tailSummed = tailSummed.get<bool>();
  }
  if (json.has("plan")) {
    const nlohmann::json& plan = json.field("plan");
    if (!plan.is_object()) json.fail("plan", "is no object");
    metadata.plan = compact(plan);
    if (metadata.plan.size() > asset_layout::kMaximumPlanBytes) json.fail("plan", "is larger than 1 MB");
  }
}

}  // namespace

std::string formatMetadata(const std::filesystem::path& path, const TransferAsset& asset) {
  const AssetMetadata& metadata = asset.metadata;
  using Json = nlohmann::ordered_json;
  const std::string problem = problemOfRanges(metadata.objects, asset.transfer.vertexCount);
  if (!problem.empty()) throw Error(path.string(), problem);
  Json sources = Json::array();
  for (const SourceFile& source : metadata.sources)
    sources.push_back({{"file", source.file}, {"sha256", source.sha256}});
  Json json = {
      {"format", "shprt-transfer"},
      {"version", asset_layout::kFormatVersion},
      {"tool", metadata.toolVersion},
      {"basis", {{"convention", kBasisConvention}, {"condonShortley", false}, {"index", kBasisIndex}}},
      {"degree", asset.transfer.degree},
      {"channels", asset.transfer.channels},
      {"model", metadata.model},
      {"rays", metadata.rays},
      {"seed", metadata.seed},
      {"sources", sources},
      {"seconds", metadata.seconds},
      {"counts", metadata.counts},
      {"notes", metadata.notes}};
  if (metadata.bounces >= 0) {
    json["bounces"] = metadata.bounces;
    json["tailSummed"] = metadata.tailSummed;
  }
  for (const ObjectRange& object : metadata.objects) {
    json["objects"].push_back({{"name", object.name},
                               {"file", object.file},
                               {"firstVertex", object.firstVertex},
                               {"vertexCount", object.vertexCount}});
  }
  const Json sampling = samplingObject(metadata);
  if (!sampling.empty()) json["sampling"] = sampling;
  if (!metadata.plan.empty()) json["plan"] = planObject(path, metadata.plan);
  return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

ParsedMetadata parseMetadata(const std::filesystem::path& path, const std::string& text) {
  nlohmann::json content;
  try {
    content = parseJson(text);
  } catch (const std::exception&) {
    // Told below, as whatever else is no object.
  }
  if (!content.is_object()) {
    throw Error(path.string(), "attribute shprtMetadata holds no JSON object",
                "the file is damaged; bake it again");
  }
  const JsonObject json(path.string(), "shprtMetadata", content);
  if (json.text("format") != "shprt-transfer") json.fail("format", "is not 'shprt-transfer'");
  checkBasis(json);
  ParsedMetadata parsed;
  parsed.degree = smallInteger(json, "degree");
  parsed.channels = smallInteger(json, "channels");
  AssetMetadata& metadata = parsed.metadata;
  metadata.formatVersion = smallInteger(json, "version");
  metadata.toolVersion = json.text("tool");
  metadata.model = json.text("model");
  metadata.rays = smallInteger(json, "rays");
  metadata.seed = json.natural("seed");
  const nlohmann::json& sources = json.list("sources");
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const JsonObject source(path.string(), "shprtMetadata.sources[" + std::to_string(i) + "]", sources[i]);
    metadata.sources.push_back({source.text("file"), source.text("sha256")});
  }
  const JsonObject seconds = json.object("seconds"), counts = json.object("counts");
  for (const std::string& name : seconds.names()) metadata.seconds[name] = seconds.number(name);
  for (const std::string& name : counts.names()) metadata.counts[name] = counts.natural(name);
  for (const nlohmann::json& note : json.list("notes")) {
    if (!note.is_string()) json.fail("notes", "has an entry that is no text");
    metadata.notes.push_back(note.get<std::string>());
  }
  parseSceneFields(path, json, metadata);
  if (json.has("sampling")) parseSampling(json.object("sampling"), metadata);
  return parsed;
}

}  // namespace shprt
