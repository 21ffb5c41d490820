#include "shprt/transfer/transfer_rows.h"

#include <algorithm>
#include <numbers>

#include "shprt/sh/basis.h"
#include "shprt/sh/zonal.h"

namespace shprt {

UnshadowedTransfer::UnshadowedTransfer(int degree)
    : degree_(degree), bandFactors_(clampedCosineFactors(degree)) {
  for (double& factor : bandFactors_) factor /= std::numbers::pi;
}

void UnshadowedTransfer::evaluate(Vec3d normal, std::span<double> results) const {
  evaluateSh(degree_, normal, results);
  for (int l = 0; l <= degree_; ++l)
    for (int m = -l; m <= l; ++m) {
      results[static_cast<std::size_t>(shIndex(l, m))] *= bandFactors_[static_cast<std::size_t>(l)];
    }
}

bool isGrey(const Scene& scene) {
  const auto isGreyColour = [](Vec3f a) { return a.x == a.y && a.y == a.z; };
  if (!std::all_of(scene.albedo.begin(), scene.albedo.end(), isGreyColour)) return false;
  for (const Image& texture : scene.textures)
    for (int y = 0; y < texture.height; ++y)
      for (int x = 0; x < texture.width; ++x)
        if (!isGreyColour(texture.at(x, y))) return false;
  return true;
}

TransferCoefficients makeTransfer(int channels, std::size_t vertexCount, int degree) {
  TransferCoefficients transfer;
  transfer.degree = degree;
  transfer.channels = channels;
  transfer.vertexCount = vertexCount;
  transfer.values.resize(static_cast<std::size_t>(channels) * static_cast<std::size_t>(transfer.rows()) *
                         vertexCount);
  return transfer;
}

TransferCoefficients makeTransfer(std::span<const Vec3f> albedo, int degree) {
  const bool grey =
      std::all_of(albedo.begin(), albedo.end(), [](Vec3f a) { return a.x == a.y && a.y == a.z; });
  return makeTransfer(grey ? 1 : 3, albedo.size(), degree);
}

void storeTransfer(std::span<const double> transfer, Vec3f albedo, std::size_t vertex,
                   TransferCoefficients& coefficients) {
  const float channelAlbedo[3] = {albedo.x, albedo.y, albedo.z};
  for (int channel = 0; channel < coefficients.channels; ++channel)
    for (int i = 0; i < coefficients.rows(); ++i) {
      coefficients.row(channel, i)[vertex] = static_cast<float>(static_cast<double>(channelAlbedo[channel]) *
                                                                transfer[static_cast<std::size_t>(i)]);
    }
}

std::vector<Vec3f> ownEmission(const Scene& scene) {
  std::vector<Vec3f> emission(scene.mesh.positions.size());
  for (std::uint32_t vertex = 0; vertex < emission.size(); ++vertex) {
    if (scene.isReceiver(vertex))
      emission[vertex] = scene.materials[scene.mesh.vertexMaterials[vertex]].emission;
  }
  return emission;
}

}  // namespace shprt
