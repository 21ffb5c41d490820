// Small assets with something in every part.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "shprt/coefficients/transfer_asset.h"

namespace shprt::test {

inline TransferAsset makeAsset(int degree, int channels, std::size_t vertices, bool textured) {
  TransferAsset asset;
  asset.transfer.degree = degree;
  asset.transfer.channels = channels;
  asset.transfer.vertexCount = vertices;
  asset.transfer.values.resize(static_cast<std::size_t>(channels * coefficientCount(degree)) * vertices);
  for (std::size_t i = 0; i < asset.transfer.values.size(); ++i)
    asset.transfer.values[i] = static_cast<float>(std::sin(0.37 * double(i)));
  for (std::size_t v = 0; v < vertices; ++v) {
    const float f = static_cast<float>(v);
    asset.positions.push_back({f, -f, 0.5f * f});
    asset.normals.push_back({0, 1, 0});
    asset.albedo.push_back({0.25f, 0.5f, 0.75f});
    if (textured) asset.textureCoordinates.push_back({f / 7, 1 - f / 9});
  }
  for (std::uint32_t t = 0; t + 2 < vertices; ++t) asset.triangles.push_back({t, t + 1, t + 2});
  asset.metadata.toolVersion = "test";
  asset.metadata.model = "shadowed";
  asset.metadata.rays = 64;
  asset.metadata.seed = std::numeric_limits<std::uint64_t>::max();
  asset.metadata.sources = {{"a \"quoted\" name.obj", "00ff"}};
  asset.metadata.seconds = {{"trace", 0.125}};
  asset.metadata.counts = {{"zeroAreaTriangles", 3}};
  asset.metadata.notes = {"a note"};
  return asset;
}

// With everything that a scene adds: light of its own, objects, bounces and a plan.
inline TransferAsset makeSceneAsset(std::size_t vertices) {
  TransferAsset asset = makeAsset(1, 3, vertices, true);
  for (std::size_t v = 0; v < vertices; ++v)
    asset.emission.push_back({static_cast<float>(v), 0.5f, -0x1p-30f * static_cast<float>(v)});
  asset.metadata.objects = {{"floor \"A\"", "floor.obj", 0, 2}, {"lamp", "l.ply", 2, vertices - 3}};
  asset.metadata.bounces = 7;
  asset.metadata.tailSummed = true;
  asset.metadata.plan = R"({"effects":[{"effect":"shadows","needed":true}],"error":0.125})";
  return asset;
}

// That with standard errors, and what the bake measured of them.
inline TransferAsset makeMeasuredAsset(std::size_t vertices) {
  TransferAsset asset = makeSceneAsset(vertices);
  const TransferCoefficients& transfer = asset.transfer;
  asset.error = {
      .degree = transfer.degree, .channels = transfer.channels, .vertexCount = vertices, .values = {}};
  asset.error.values.resize(static_cast<std::size_t>(asset.error.channels * asset.error.bands()) * vertices);
  for (std::size_t i = 0; i < asset.error.values.size(); ++i)
    asset.error.values[i] = 0x1p-10f * static_cast<float>(i);
  for (std::size_t v = 0; v < vertices; ++v)
    asset.emissionError.push_back({0, 0x1p-8f * static_cast<float>(v), 0.25f});
  asset.metadata.samplingError = 0.0078125;
  asset.metadata.samplingErrorBound = 0.01;
  asset.metadata.verticesByRays = {{0, 2}, {64, vertices - 3}, {65536, 1}};
  return asset;
}

}  // namespace shprt::test
