// Baked transfer as plain data: the waist between baking (which writes it) and relighting (which reads it).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/sh/basis.h"

namespace shprt {

// Transfer coefficients of all vertices. values is laid out [channel][coefficient][vertex]: each row is one
// coefficient over all vertices, as in the file, and as relighting streams it. Outgoing radiance of vertex v
// under light c is sum_i values(channel, i, v) * c_i; albedo/pi is folded in.
struct TransferCoefficients {
  int degree = 0;
  int channels = 1;  // 1 where the three colour channels agree, else 3
  std::size_t vertexCount = 0;
  std::vector<float> values;

  int rows() const { return coefficientCount(degree); }
  const float* row(int channel, int coefficient) const {
    return values.data() + (static_cast<std::size_t>(channel) * static_cast<std::size_t>(rows()) +
                            static_cast<std::size_t>(coefficient)) *
                               vertexCount;
  }
  float* row(int channel, int coefficient) {
    return const_cast<float*>(std::as_const(*this).row(channel, coefficient));
  }
};

// What sampling leaves uncertain in the transfer: per vertex, channel and band l the standard error, the root
// of the expected squared 2-norm of the error of that band's 2l+1 coefficients, in the units of transfer
// (albedo folded in). Per vertex they are estimates from few numbers; what is exact has zeros.
struct TransferError {
  int degree = 0;
  int channels = 1;  // as the transfer
  std::size_t vertexCount = 0;
  std::vector<float> values;  // [channel][band][vertex]

  bool empty() const { return values.empty(); }
  int bands() const { return degree + 1; }
  const float* row(int channel, int band) const {
    return values.data() + (static_cast<std::size_t>(channel) * static_cast<std::size_t>(bands()) +
                            static_cast<std::size_t>(band)) *
                               vertexCount;
  }
  float* row(int channel, int band) { return const_cast<float*>(std::as_const(*this).row(channel, band)); }
};

struct SourceFile {
  std::string file;    // as given on the command line
  std::string sha256;  // of its bytes
};

// Consecutive vertices of an asset that come from one object of the scene.
struct ObjectRange {
  std::string name;  // of the object; an object may have several ranges
  std::string file;  // as the scene gives it
  std::uint64_t firstVertex = 0, vertexCount = 0;
  bool operator==(const ObjectRange&) const = default;
};

// What the asset says about itself; written as EXR attributes and as one JSON string.
struct AssetMetadata {
  int formatVersion = 1;
  std::string toolVersion;
  std::string model;  // "unshadowed", "shadowed", "interreflected"
  int rays = 0;       // per vertex; 0 where none were traced
  std::uint64_t seed = 0;
  std::vector<SourceFile> sources;
  std::map<std::string, double> seconds;        // spent: "load", "build", "trace", ...
  std::map<std::string, std::uint64_t> counts;  // what the loader found, left out and mended; rays traced
  std::vector<std::string> notes;
  // In increasing order and without overlap; empty where the asset is one mesh or was made before there were
  // scenes.
  std::vector<ObjectRange> objects;
  int bounces = -1;         // of light between surfaces that transfer holds; -1 where the model has none
  bool tailSummed = false;  // whether later bounces were added as a geometric series
  // A JSON object: which effects the scene was found to call for, and what was skipped and why; "" for none.
  // Reading puts its fields in alphabetical order.
  std::string plan;
  // What sampling left uncertain over the whole scene, as SamplingStatistics measures it (transfer/bake.h);
  // negative where it was not measured.
  double samplingError = -1, samplingErrorBound = -1;
  // How many vertices of the scene took how many rays (0: exact without). Empty where all took `rays`; where
  // not, `rays` is the mean, rounded.
  std::map<int, std::uint64_t> verticesByRays;
};

// A self-contained asset: mesh and transfer.
struct TransferAsset {
  TransferCoefficients transfer;
  std::vector<Vec3f> positions;  // per vertex, in the source's units
  std::vector<Vec3f> normals;
  std::vector<Vec3f> albedo;         // linear Rec.709, as folded into transfer
  std::vector<Vec3f> emission;       // outgoing radiance that the scene's own lights cause; or empty
  TransferError error;               // or empty
  std::vector<Vec3f> emissionError;  // standard errors of emission; empty unless both it and error are there
  std::vector<Vec2f> textureCoordinates;  // or empty
  std::vector<std::array<std::uint32_t, 3>> triangles;
  AssetMetadata metadata;
};

}  // namespace shprt
