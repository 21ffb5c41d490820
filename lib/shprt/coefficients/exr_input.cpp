#include "shprt/coefficients/exr_input.h"

#include <OpenEXR/ImfChannelList.h>

#include "shprt/base/error.h"
#include "shprt/base/exr_header.h"

namespace shprt {

std::unique_ptr<Imf::MultiPartInputFile> openExr(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) throw Error(path.string(), "no such file", "check the path");
  if (!isExrFile(path)) throw Error(path.string(), "is no OpenEXR file", "give an asset made by shprt bake");
  try {
    if (hasWholeExrHeader(path)) return std::make_unique<Imf::MultiPartInputFile>(path.c_str(), 0, false);
  } catch (const std::exception&) {
    // OpenEXR's messages name its own internals; what helps the user is below.
  }
  throw Error(path.string(), "is a damaged or truncated OpenEXR file", "bake it again");
}

int width(const Imf::Header& header) {
  return header.dataWindow().max.x - header.dataWindow().min.x + 1;
}

int height(const Imf::Header& header) {
  return header.dataWindow().max.y - header.dataWindow().min.y + 1;
}

std::string channelNames(const Imf::Header& header) {
  std::string names;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    names += (names.empty() ? "" : ",") + std::string(channel.name());
  }
  return names;
}

}  // namespace shprt
