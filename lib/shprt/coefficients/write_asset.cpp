// The asset as multi-part OpenEXR: transfer in tiles that hold all coefficients of a block of vertices,
// errors in a row per band, geometry in single rows.

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfTiledOutputPart.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/coefficients/asset_file.h"
#include "shprt/coefficients/asset_layout.h"
#include "shprt/coefficients/asset_metadata.h"
#include "shprt/coefficients/exr_output.h"

namespace shprt {
namespace {

using namespace asset_layout;

Imf::Compression compressionOf(AssetCompression compression) {
  switch (compression) {
    case AssetCompression::kZip:
      return Imf::ZIP_COMPRESSION;
    case AssetCompression::kZips:
      return Imf::ZIPS_COMPRESSION;
    case AssetCompression::kPiz:
      return Imf::PIZ_COMPRESSION;
    case AssetCompression::kNone:
      break;
  }
  return Imf::NO_COMPRESSION;
}

// About 4 MB of transfer per tile, a multiple of 64 vertices.
int tileWidth(const TransferCoefficients& transfer, std::size_t bytesPerValue) {
  const std::size_t perVertex = bytesPerValue * static_cast<std::size_t>(transfer.rows() * transfer.channels);
  const std::size_t vertices = (std::size_t{4} << 20) / perVertex / 64 * 64;
  return static_cast<int>(std::clamp<std::size_t>(vertices, 64, kMaximumTileWidth));
}

class AssetWriter {
 public:
  AssetWriter(const std::filesystem::path& name, const TransferAsset& asset, const WriteAssetOptions& options)
      : name_(name), asset_(asset), options_(options) {}

  void write(const std::filesystem::path& path) {
    check();
    if (options_.half) roundToHalf();
    ExrOutput output(path, name_);
    try {
      const std::vector<Imf::Header> headers = makeHeaders();
      Imf::MultiPartOutputFile file(output, headers.data(), static_cast<int>(headers.size()));
      writeTransfer(file);
      int part = 1;
      writeRow(file, part++, {"X", "Y", "Z"}, &asset_.positions[0].x, 3);
      writeRow(file, part++, {"X", "Y", "Z"}, &asset_.normals[0].x, 3);
      writeRow(file, part++, {"R", "G", "B"}, &asset_.albedo[0].x, 3);
      if (!asset_.emission.empty()) writeRow(file, part++, {"R", "G", "B"}, &asset_.emission[0].x, 3);
      if (!asset_.error.empty()) writeError(file, part++);
      if (!asset_.emissionError.empty())
        writeRow(file, part++, {"R", "G", "B"}, &asset_.emissionError[0].x, 3);
      if (!asset_.textureCoordinates.empty())
        writeRow(file, part++, {"U", "V"}, &asset_.textureCoordinates[0].x, 2);
      writeTriangles(file, part);
    } catch (const Error&) {
      throw;
    } catch (const std::exception& problem) {
      throw Error(name_.string(), std::string("cannot be written: ") + problem.what());
    }
    output.close();
  }

 private:
  void check() const {
    const TransferCoefficients& transfer = asset_.transfer;
    const std::size_t count = transfer.vertexCount;
    if (count == 0 || asset_.triangles.empty())
      throw Error(name_.string(), "the asset has no vertices or no triangles");
    if (count > 0x7fffffff || asset_.triangles.size() > 0x7fffffff) {
      throw Error(name_.string(),
                  "the asset has more vertices or triangles than an OpenEXR image can be wide",
                  "split the mesh");
    }
    if (asset_.positions.size() != count || asset_.normals.size() != count || asset_.albedo.size() != count ||
        (!asset_.emission.empty() && asset_.emission.size() != count) ||
        (!asset_.textureCoordinates.empty() && asset_.textureCoordinates.size() != count)) {
      throw Error(name_.string(), "the asset's parts have different numbers of vertices");
    }
    if (transfer.degree < 0 || transfer.degree > kMaximumBakeDegree ||
        (transfer.channels != 1 && transfer.channels != 3) ||
        transfer.values.size() != static_cast<std::size_t>(transfer.channels * transfer.rows()) * count) {
      throw Error(name_.string(),
                  "the asset's transfer does not have the size that its degree, channels and "
                  "vertices ask for");
    }
    checkErrors();
  }

  void checkErrors() const {
    const TransferError& error = asset_.error;
    const TransferCoefficients& transfer = asset_.transfer;
    if (!error.empty() &&
        (error.degree != transfer.degree || error.channels != transfer.channels ||
         error.vertexCount != transfer.vertexCount ||
         error.values.size() != static_cast<std::size_t>(error.channels * error.bands()) * error.vertexCount))
      throw Error(name_.string(), "the asset's errors do not have the shape of its transfer");
    if (!asset_.emissionError.empty() &&
        (error.empty() || asset_.emissionError.size() != asset_.emission.size()))
      throw Error(name_.string(), "the asset has errors of emission that go with no emission or no errors");
  }

  void roundToHalf() {
    half_.resize(asset_.transfer.values.size());
    for (std::size_t i = 0; i < half_.size(); ++i) {
      half_[i] = Imath::half(asset_.transfer.values[i]);
      if (!half_[i].isInfinity() && !half_[i].isNan()) continue;
      const std::size_t vertex = i % asset_.transfer.vertexCount;
      const std::size_t coefficient =
          i / asset_.transfer.vertexCount % static_cast<std::size_t>(asset_.transfer.rows());
      throw Error(name_.string(),
                  "coefficient " + std::to_string(coefficient) + " of vertex " + std::to_string(vertex) +
                      " is " + std::to_string(asset_.transfer.values[i]) + ", beyond half",
                  "leave out --half");
    }
  }

  static Imath::Box2i window(std::size_t width, int height) {
    return {{0, 0}, {static_cast<int>(width) - 1, height - 1}};
  }

  Imf::Header makeHeader(const char* name, std::size_t width, int height,
                         std::initializer_list<const char*> channels, Imf::PixelType type) const {
    // All parts must state the same display window, whatever data they hold.
    Imf::Header header(window(asset_.transfer.vertexCount, asset_.transfer.rows()), window(width, height));
    header.setName(name);
    header.setType(Imf::SCANLINEIMAGE);
    header.compression() = compressionOf(options_.compression);
    for (const char* channel : channels) header.channels().insert(channel, Imf::Channel(type));
    return header;
  }

  std::vector<Imf::Header> makeHeaders() const {
    const TransferCoefficients& transfer = asset_.transfer;
    const Imf::PixelType type = options_.half ? Imf::HALF : Imf::FLOAT;
    std::vector<Imf::Header> headers;
    headers.push_back(
        transfer.channels == 1
            ? makeHeader(kTransfer, transfer.vertexCount, transfer.rows(), {"Y"}, type)
            : makeHeader(kTransfer, transfer.vertexCount, transfer.rows(), {"R", "G", "B"}, type));
    Imf::Header& header = headers.back();
    header.setType(Imf::TILEDIMAGE);
    header.setTileDescription(
        Imf::TileDescription(static_cast<unsigned>(tileWidth(transfer, options_.half ? 2 : 4)),
                             static_cast<unsigned>(transfer.rows())));
    header.insert(kVersionAttribute, Imf::IntAttribute(kFormatVersion));
    header.insert(kDegreeAttribute, Imf::IntAttribute(transfer.degree));
    header.insert(kConventionAttribute, Imf::StringAttribute(kConvention));
    header.insert(kModelAttribute, Imf::StringAttribute(asset_.metadata.model));
    header.insert(kRaysAttribute, Imf::IntAttribute(asset_.metadata.rays));
    header.insert(kSeedAttribute, Imf::StringAttribute(std::to_string(asset_.metadata.seed)));
    header.insert(kToolAttribute, Imf::StringAttribute(asset_.metadata.toolVersion));
    header.insert(kMetadataAttribute, Imf::StringAttribute(formatMetadata(name_, asset_)));
    headers.push_back(makeHeader(kPositions, transfer.vertexCount, 1, {"X", "Y", "Z"}, Imf::FLOAT));
    headers.push_back(makeHeader(kNormals, transfer.vertexCount, 1, {"X", "Y", "Z"}, Imf::FLOAT));
    headers.push_back(makeHeader(kAlbedo, transfer.vertexCount, 1, {"R", "G", "B"}, Imf::FLOAT));
    if (!asset_.emission.empty())
      headers.push_back(makeHeader(kEmission, transfer.vertexCount, 1, {"R", "G", "B"}, Imf::FLOAT));
    if (!asset_.error.empty()) {
      headers.push_back(
          transfer.channels == 1
              ? makeHeader(kError, transfer.vertexCount, asset_.error.bands(), {"Y"}, Imf::FLOAT)
              : makeHeader(kError, transfer.vertexCount, asset_.error.bands(), {"R", "G", "B"}, Imf::FLOAT));
    }
    if (!asset_.emissionError.empty())
      headers.push_back(makeHeader(kEmissionError, transfer.vertexCount, 1, {"R", "G", "B"}, Imf::FLOAT));
    if (!asset_.textureCoordinates.empty())
      headers.push_back(makeHeader(kTextureCoordinates, transfer.vertexCount, 1, {"U", "V"}, Imf::FLOAT));
    headers.push_back(makeHeader(kTriangles, asset_.triangles.size(), 1, {"A", "B", "C"}, Imf::UINT));
    return headers;
  }

  void writeTransfer(Imf::MultiPartOutputFile& file) {
    const TransferCoefficients& transfer = asset_.transfer;
    const std::size_t size = options_.half ? 2 : 4;
    const char* base = options_.half ? reinterpret_cast<const char*>(half_.data())
                                     : reinterpret_cast<const char*>(transfer.values.data());
    Imf::FrameBuffer frame;
    for (int channel = 0; channel < transfer.channels; ++channel) {
      const std::size_t offset = static_cast<std::size_t>(channel) *
                                 static_cast<std::size_t>(transfer.rows()) * transfer.vertexCount;
      frame.insert(channelName(transfer.channels, channel),
                   Imf::Slice(options_.half ? Imf::HALF : Imf::FLOAT, const_cast<char*>(base + offset * size),
                              size, transfer.vertexCount * size));
    }
    Imf::TiledOutputPart part(file, 0);
    part.setFrameBuffer(frame);
    part.writeTiles(0, part.numXTiles() - 1, 0, part.numYTiles() - 1);
  }

  void writeError(Imf::MultiPartOutputFile& file, int index) const {
    const TransferError& error = asset_.error;
    Imf::FrameBuffer frame;
    for (int channel = 0; channel < error.channels; ++channel) {
      frame.insert(channelName(error.channels, channel),
                   Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(const_cast<float*>(error.row(channel, 0))),
                              sizeof(float), error.vertexCount * sizeof(float)));
    }
    Imf::OutputPart part(file, index);
    part.setFrameBuffer(frame);
    part.writePixels(error.bands());
  }

  void writeRow(Imf::MultiPartOutputFile& file, int index, std::initializer_list<const char*> channels,
                const float* values, std::size_t stride) const {
    Imf::FrameBuffer frame;
    std::size_t offset = 0;
    for (const char* channel : channels) {
      frame.insert(channel,
                   Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(const_cast<float*>(values + offset++)),
                              stride * sizeof(float), 0));
    }
    Imf::OutputPart part(file, index);
    part.setFrameBuffer(frame);
    part.writePixels(1);
  }

  void writeTriangles(Imf::MultiPartOutputFile& file, int index) const {
    Imf::FrameBuffer frame;
    const char* names[] = {"A", "B", "C"};
    for (std::size_t k = 0; k < 3; ++k) {
      frame.insert(
          names[k],
          Imf::Slice(Imf::UINT, reinterpret_cast<char*>(const_cast<std::uint32_t*>(&asset_.triangles[0][k])),
                     3 * sizeof(std::uint32_t), 0));
    }
    Imf::OutputPart part(file, index);
    part.setFrameBuffer(frame);
    part.writePixels(1);
  }

  const std::filesystem::path& name_;
  const TransferAsset& asset_;
  const WriteAssetOptions& options_;
  std::vector<Imath::half> half_;
};

}  // namespace

void writeAsset(const std::filesystem::path& path, const TransferAsset& asset,
                const WriteAssetOptions& options) {
  AtomicFile target(path);
  AssetWriter(path, asset, options).write(target.path());
  target.commit();
}

}  // namespace shprt
