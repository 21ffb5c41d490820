// AssetMetadata as the JSON string that the file carries.
#pragma once

#include <filesystem>
#include <string>

#include "shprt/coefficients/transfer_asset.h"

namespace shprt {

// path is for messages. Throws Error when the plan is no JSON object, too large or too deeply nested, or when
// the objects' ranges overlap or end beyond the vertices.
std::string formatMetadata(const std::filesystem::path& path, const TransferAsset& asset);
// path is for messages. Fills degree, channels and everything of AssetMetadata; the caller compares the first
// two, and the objects' ranges, with the parts. Throws Error naming the field that is missing or makes no
// sense.
struct ParsedMetadata {
  int degree = 0, channels = 0;
  AssetMetadata metadata;
};
ParsedMetadata parseMetadata(const std::filesystem::path& path, const std::string& text);

}  // namespace shprt
