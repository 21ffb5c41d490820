#include "shprt/coefficients/asset_metadata.h"

#include <cstdint>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>

#include "shprt/base/error.h"
#include "shprt/coefficients/asset_layout.h"
#include "shprt/coefficients/basis_name.h"
#include "shprt/base/json_input.h"

namespace shprt {
namespace {

int smallInteger(const JsonObject& json, const char* field) {
  const std::int64_t value = json.integer(field);
  if (value < 0 || value > std::numeric_limits<int>::max()) json.fail(field, "is out of range");
  return static_cast<int>(value);
}

}  // namespace

std::string formatMetadata(const TransferAsset& asset) {
  const AssetMetadata& metadata = asset.metadata;
  using Json = nlohmann::ordered_json;
  Json sources = Json::array();
  for (const SourceFile& source : metadata.sources)
    sources.push_back({{"file", source.file}, {"sha256", source.sha256}});
  const Json json = {
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
  return parsed;
}

}  // namespace shprt
