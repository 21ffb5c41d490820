// How an asset's parts are stored, from their headers alone.

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfTileDescription.h>

#include "shprt/coefficients/asset_file.h"
#include "shprt/coefficients/exr_input.h"

namespace shprt {
namespace {

const char* typeName(const Imf::Header& header) {
  const auto first = header.channels().begin();
  if (first == header.channels().end()) return "none";
  return first.channel().type == Imf::HALF ? "half" : first.channel().type == Imf::FLOAT ? "float" : "uint";
}

const char* compressionName(Imf::Compression compression) {
  switch (compression) {
    case Imf::NO_COMPRESSION:
      return "none";
    case Imf::RLE_COMPRESSION:
      return "rle";
    case Imf::ZIP_COMPRESSION:
      return "zip";
    case Imf::ZIPS_COMPRESSION:
      return "zips";
    case Imf::PIZ_COMPRESSION:
      return "piz";
    default:
      return "other";
  }
}

}  // namespace

std::vector<AssetPart> listAssetParts(const std::filesystem::path& path) {
  const auto file = openExr(path);
  std::vector<AssetPart> parts;
  for (int i = 0; i < file->parts(); ++i) {
    const Imf::Header& header = file->header(i);
    parts.push_back({header.hasName() ? header.name() : "",
                     header.hasTileDescription()
                         ? "tiles of " + std::to_string(header.tileDescription().xSize)
                         : "scan lines",
                     typeName(header), compressionName(header.compression()), channelNames(header),
                     width(header), height(header)});
  }
  return parts;
}

}  // namespace shprt
