// The asset as one multi-part OpenEXR file; docs/file-formats.md specifies it. The one door to OpenEXR.
#pragma once

#include <cstdint>
#include <filesystem>

#include "shprt/coefficients/transfer_asset.h"

namespace shprt {

enum class AssetCompression { kNone, kZip, kZips, kPiz };

struct WriteAssetOptions {
  bool half = false;                                       // transfer as 16-bit half instead of 32-bit float
  AssetCompression compression = AssetCompression::kNone;  // the measured default, see docs/file-formats.md
};

// Writes atomically. Throws Error (no space, no permission, a value that half cannot hold).
void writeAsset(const std::filesystem::path& path, const TransferAsset& asset,
                const WriteAssetOptions& options = {});

// Whether it is an OpenEXR file that holds a shprt asset (as opposed to a picture); false for anything
// unreadable.
bool isAssetFile(const std::filesystem::path& path);

// Reads and checks everything: sizes before allocating, index ranges, consistency of parts with each other
// and with the metadata. Throws Error for what is truncated, newer, or inconsistent.
TransferAsset readAsset(const std::filesystem::path& path);

// How the file is stored, for `shprt info`.
struct AssetPart {
  std::string name, type, pixelType, compression, channels;
  int width = 0, height = 0;
};
std::vector<AssetPart> listAssetParts(const std::filesystem::path& path);

}  // namespace shprt
