#include "shprt/coefficients/asset_metadata.h"

#include <nlohmann/json.hpp>

#include "shprt/base/error.h"
#include "shprt/coefficients/asset_layout.h"

namespace shprt {

using Json = nlohmann::ordered_json;

std::string formatMetadata(const TransferAsset& asset) {
  const AssetMetadata& metadata = asset.metadata;
  Json sources = Json::array();
  for (const SourceFile& source : metadata.sources)
    sources.push_back({{"file", source.file}, {"sha256", source.sha256}});
  const Json json = {
      {"format", "shprt-transfer"},
      {"version", asset_layout::kFormatVersion},
      {"tool", metadata.toolVersion},
      {"basis", {{"convention", "real-orthonormal"}, {"condonShortley", false}, {"index", "l(l+1)+m"}}},
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
  ParsedMetadata parsed;
  try {
    const Json json = Json::parse(text);
    const Json& basis = json.at("basis");
    if (json.at("format") != "shprt-transfer" || basis.at("convention") != "real-orthonormal" ||
        basis.at("condonShortley") != false || basis.at("index") != "l(l+1)+m") {
      throw Error(path.string(), "attribute shprtMetadata: another format or convention than this shprt's",
                  "bake it again");
    }
    parsed.degree = json.at("degree").get<int>();
    parsed.channels = json.at("channels").get<int>();
    AssetMetadata& metadata = parsed.metadata;
    metadata.formatVersion = json.at("version").get<int>();
    metadata.toolVersion = json.at("tool").get<std::string>();
    metadata.model = json.at("model").get<std::string>();
    metadata.rays = json.at("rays").get<int>();
    metadata.seed = json.at("seed").get<std::uint64_t>();
    for (const Json& source : json.at("sources")) {
      metadata.sources.push_back(
          {source.at("file").get<std::string>(), source.at("sha256").get<std::string>()});
    }
    metadata.seconds = json.at("seconds").get<std::map<std::string, double>>();
    metadata.counts = json.at("counts").get<std::map<std::string, std::uint64_t>>();
    metadata.notes = json.at("notes").get<std::vector<std::string>>();
  } catch (const Json::exception&) {
    throw Error(path.string(), "attribute shprtMetadata cannot be read",
                "the file is damaged; bake it again");
  }
  return parsed;
}

}  // namespace shprt
