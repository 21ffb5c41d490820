// Reading the asset: everything a header claims is checked against the file's size before memory is taken for
// it, and all parts against each other.

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTiledInputPart.h>

#include <cstddef>
#include <memory>

#include "shprt/base/error.h"
#include "shprt/coefficients/asset_file.h"
#include "shprt/coefficients/asset_layout.h"
#include "shprt/coefficients/asset_metadata.h"
#include "shprt/coefficients/asset_values.h"
#include "shprt/coefficients/exr_input.h"
#include "shprt/coefficients/object_ranges.h"

namespace shprt {
namespace {

using namespace asset_layout;

// The most that one byte of a file can stand for; 0 where an asset may not be stored so.
std::uint64_t mostExpansion(Imf::Compression compression) {
  switch (compression) {
    case Imf::NO_COMPRESSION:
      return 1;
    case Imf::RLE_COMPRESSION:
      return 64;
    case Imf::ZIP_COMPRESSION:
    case Imf::ZIPS_COMPRESSION:
      return 1032;  // deflate's bound
    case Imf::PIZ_COMPRESSION:
      return 512;  // a run of at most 255 16-bit values takes ten bits
    default:
      return 0;
  }
}

bool isAsset(const Imf::MultiPartInputFile& file) {
  const Imf::Header& header = file.header(0);
  return header.hasName() && header.name() == kTransfer &&
         header.findTypedAttribute<Imf::IntAttribute>(kVersionAttribute);
}

class AssetReader {
 public:
  explicit AssetReader(const std::filesystem::path& path)
      : path_(path), file_(openExr(path)), bytes_(std::filesystem::file_size(path)) {}

  TransferAsset read() {
    if (!isAsset(*file_))
      throw Error(path_.string(), "is an OpenEXR picture, not an asset", "give an asset made by shprt bake");
    readMetadata();
    const auto vertices = asset_.transfer.vertexCount;
    asset_.positions = readVectors(kPositions, {"X", "Y", "Z"}, "X,Y,Z");
    asset_.normals = readVectors(kNormals, {"X", "Y", "Z"}, "X,Y,Z");
    asset_.albedo = readVectors(kAlbedo, {"R", "G", "B"}, "B,G,R");
    if (find(kEmission) >= 0) asset_.emission = readVectors(kEmission, {"R", "G", "B"}, "B,G,R");
    readErrors();
    if (find(kTextureCoordinates) >= 0) {
      asset_.textureCoordinates.resize(checkRow(kTextureCoordinates, "U,V", Imf::FLOAT, 8, vertices));
      readRow(kTextureCoordinates, {"U", "V"}, Imf::FLOAT, asset_.textureCoordinates.data(), 8);
    }
    asset_.triangles.resize(checkRow(kTriangles, "A,B,C", Imf::UINT, 12, 0));
    readRow(kTriangles, {"A", "B", "C"}, Imf::UINT, asset_.triangles.data(), 12);
    readTransfer();
    const std::string problem = problemOfValues(asset_);
    if (!problem.empty()) fail(problem);
    return std::move(asset_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem,
                         const std::string& remedy = "the file is damaged; bake it again") const {
    throw Error(path_.string(), problem, remedy);
  }

  int find(const char* name) const {
    for (int part = 0; part < file_->parts(); ++part) {
      if (file_->header(part).hasName() && file_->header(part).name() == name) return part;
    }
    return -1;
  }

  int require(const char* name) const {
    const int part = find(name);
    if (part < 0) fail(std::string("part ") + name + " is missing");
    return part;
  }

  // What all parts have in common: lossless, anchored at pixel 0,0, and no larger than the file can hold.
  void checkStorage(const char* name, const Imf::Header& header, std::uint64_t bytesPerPixel) const {
    const std::uint64_t expansion = mostExpansion(header.compression());
    if (expansion == 0)
      fail(std::string("part ") + name + " has a compression other than none, rle, zip, zips and piz");
    if (header.dataWindow().min != Imath::V2i(0, 0))
      fail(std::string("part ") + name + " does not begin at pixel 0,0");
    const std::uint64_t claimed = static_cast<std::uint64_t>(width(header)) *
                                  static_cast<std::uint64_t>(height(header)) * bytesPerPixel;
    if (claimed / expansion > bytes_)
      fail(std::string("part ") + name + " claims more data than " + std::to_string(bytes_) +
           " bytes can hold");
  }

  void readMetadata() {
    const Imf::Header& header = file_->header(0);
    const int version = header.typedAttribute<Imf::IntAttribute>(kVersionAttribute).value();
    if (version != kFormatVersion) {
      fail("has format version " + std::to_string(version) + "; this shprt reads version " +
               std::to_string(kFormatVersion),
           version > kFormatVersion ? "use a newer shprt" : "bake it again");
    }
    const auto* degree = header.findTypedAttribute<Imf::IntAttribute>(kDegreeAttribute);
    const auto* convention = header.findTypedAttribute<Imf::StringAttribute>(kConventionAttribute);
    const auto* metadata = header.findTypedAttribute<Imf::StringAttribute>(kMetadataAttribute);
    if (!degree) fail("attribute shprtDegree is missing");
    if (!convention) fail("attribute shprtConvention is missing");
    if (!metadata) fail("attribute shprtMetadata is missing");
    if (convention->value() != kConvention)
      fail("attribute shprtConvention names another convention", "bake it again with this shprt");
    ParsedMetadata parsed = parseMetadata(path_, metadata->value());
    TransferCoefficients& transfer = asset_.transfer;
    transfer.degree = degree->value();
    if (transfer.degree < 0 || transfer.degree > kMaximumBakeDegree)
      fail("attribute shprtDegree is " + std::to_string(transfer.degree) + ", outside 0 to 32");
    const std::string channels = channelNames(header);
    if (channels != "Y" && channels != "B,G,R")
      fail("part transfer has the channels " + channels.substr(0, 40) + " instead of Y or R,G,B");
    transfer.channels = channels == "Y" ? 1 : 3;
    transfer.vertexCount = static_cast<std::size_t>(width(header));
    if (parsed.degree != transfer.degree || parsed.channels != transfer.channels ||
        parsed.metadata.formatVersion != version) {
      fail("attribute shprtMetadata disagrees with the file's degree, channels or version");
    }
    if (height(header) != transfer.rows()) {
      fail("part transfer has " + std::to_string(height(header)) + " rows where degree " +
           std::to_string(transfer.degree) + " needs " + std::to_string(transfer.rows()));
    }
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
      if (channel.channel().type == Imf::UINT || channel.channel().xSampling != 1 ||
          channel.channel().ySampling != 1)
        fail("part transfer holds no float or half values");
    }
    checkTiles(header);
    // Half is the least that a value takes.
    checkStorage(kTransfer, header, std::uint64_t{2} * static_cast<std::uint64_t>(transfer.channels));
    checkAttributes(header, parsed.metadata);
    const std::string problem = problemOfRanges(parsed.metadata.objects, transfer.vertexCount);
    if (!problem.empty()) fail("attribute shprtMetadata: " + problem);
    asset_.metadata = std::move(parsed.metadata);
  }

  // OpenEXR takes memory for whole tiles, however few pixels lie in them.
  void checkTiles(const Imf::Header& header) const {
    if (!header.hasTileDescription()) fail("part transfer is not tiled");
    const Imf::TileDescription& tiles = header.tileDescription();
    if (tiles.mode != Imf::ONE_LEVEL || tiles.xSize > kMaximumTileWidth ||
        tiles.ySize != static_cast<unsigned>(asset_.transfer.rows())) {
      fail("part transfer has tiles of " + std::to_string(tiles.xSize) + " x " + std::to_string(tiles.ySize) +
           " instead of at most " + std::to_string(kMaximumTileWidth) + " x " +
           std::to_string(asset_.transfer.rows()) + " on one level");
    }
  }

  // Attributes repeat what the JSON says, for tools that show them; the two may not tell different stories.
  void checkAttributes(const Imf::Header& header, const AssetMetadata& metadata) const {
    const auto* model = header.findTypedAttribute<Imf::StringAttribute>(kModelAttribute);
    const auto* rays = header.findTypedAttribute<Imf::IntAttribute>(kRaysAttribute);
    if (model && model->value() != metadata.model) fail("attribute shprtModel disagrees with shprtMetadata");
    if (rays && rays->value() != metadata.rays) fail("attribute shprtRays disagrees with shprtMetadata");
  }

  // The width of a part, after all checks. expected 0: any.
  std::size_t checkRows(const char* name, const char* channels, Imf::PixelType type,
                        std::size_t bytesPerPixel, std::size_t expected, int rows) const {
    const Imf::Header& header = file_->header(require(name));
    const auto count = static_cast<std::size_t>(width(header));
    if (channelNames(header) != channels)
      fail(std::string("part ") + name + " has the channels " + channelNames(header).substr(0, 40) +
           " instead of " + channels);
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
      if (channel.channel().type != type || channel.channel().xSampling != 1 ||
          channel.channel().ySampling != 1)
        fail(std::string("part ") + name + " has values of another type");
    }
    if (height(header) != rows || (expected && count != expected)) {
      fail(std::string("part ") + name + " is " + std::to_string(count) + " x " +
           std::to_string(height(header)) +
           (expected ? ", not " + std::to_string(expected) + " x " + std::to_string(rows) : ""));
    }
    checkStorage(name, header, bytesPerPixel);
    return count;
  }

  std::size_t checkRow(const char* name, const char* channels, Imf::PixelType type, std::size_t bytesPerPixel,
                       std::size_t expected) const {
    return checkRows(name, channels, type, bytesPerPixel, expected, 1);
  }

  template <typename Read>
  void guarded(const char* name, const Read& read) const {
    try {
      read();
    } catch (const std::exception&) {
      fail(std::string("part ") + name + " is damaged or truncated", "bake it again");
    }
  }

  void readRow(const char* name, std::initializer_list<const char*> channels, Imf::PixelType type,
               void* values, std::size_t stride) const {
    const int index = require(name);
    guarded(name, [&] {
      Imf::FrameBuffer frame;
      char* base = static_cast<char*>(values);
      for (const char* channel : channels) {
        frame.insert(channel, Imf::Slice(type, base, stride, 0));
        base += 4;
      }
      Imf::InputPart part(*file_, index);
      part.setFrameBuffer(frame);
      part.readPixels(0);
    });
  }

  // One vector per vertex: a place, a direction or a colour.
  std::vector<Vec3f> readVectors(const char* name, std::initializer_list<const char*> channels,
                                 const char* channelsInFile) const {
    std::vector<Vec3f> vectors(
        checkRow(name, channelsInFile, Imf::FLOAT, sizeof(Vec3f), asset_.transfer.vertexCount));
    readRow(name, channels, Imf::FLOAT, vectors.data(), sizeof(Vec3f));
    return vectors;
  }

  // Both parts are optional, but errors of emission alone would be half the story.
  void readErrors() {
    if (find(kError) >= 0) readTransferError();
    if (find(kEmissionError) < 0) return;
    if (asset_.error.empty() || asset_.emission.empty())
      fail(std::string("part ") + kEmissionError + " needs the parts " + kError + " and " + kEmission);
    asset_.emissionError = readVectors(kEmissionError, {"R", "G", "B"}, "B,G,R");
  }

  void readTransferError() {
    const TransferCoefficients& transfer = asset_.transfer;
    TransferError& error = asset_.error;
    error.degree = transfer.degree;
    error.channels = transfer.channels;
    const auto channels = static_cast<std::size_t>(transfer.channels);
    error.vertexCount = checkRows(kError, transfer.channels == 1 ? "Y" : "B,G,R", Imf::FLOAT,
                                  channels * sizeof(float), transfer.vertexCount, error.bands());
    error.values.resize(channels * static_cast<std::size_t>(error.bands()) * error.vertexCount);
    guarded(kError, [&] {
      Imf::FrameBuffer frame;
      for (int channel = 0; channel < error.channels; ++channel) {
        frame.insert(channelName(error.channels, channel),
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(error.row(channel, 0)), sizeof(float),
                                error.vertexCount * sizeof(float)));
      }
      Imf::InputPart part(*file_, require(kError));
      part.setFrameBuffer(frame);
      part.readPixels(0, error.bands() - 1);
    });
  }

  void readTransfer() {
    TransferCoefficients& transfer = asset_.transfer;
    guarded(kTransfer, [&] {
      transfer.values.resize(static_cast<std::size_t>(transfer.channels * transfer.rows()) *
                             transfer.vertexCount);
      Imf::FrameBuffer frame;
      for (int channel = 0; channel < transfer.channels; ++channel) {
        frame.insert(channelName(transfer.channels, channel),
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(transfer.row(channel, 0)), sizeof(float),
                                transfer.vertexCount * sizeof(float)));
      }
      Imf::TiledInputPart part(*file_, 0);
      part.setFrameBuffer(frame);
      part.readTiles(0, part.numXTiles() - 1, 0, part.numYTiles() - 1);
    });
  }

  std::filesystem::path path_;
  std::unique_ptr<Imf::MultiPartInputFile> file_;
  std::uint64_t bytes_;
  TransferAsset asset_;
};

}  // namespace

bool isAssetFile(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  try {
    return isAsset(*openExr(path));
  } catch (const Error&) {
    return false;
  }
}

TransferAsset readAsset(const std::filesystem::path& path) {
  return AssetReader(path).read();
}

}  // namespace shprt
