#include "shprt/transfer/transfer_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "shprt/sh/basis.h"
#include "shprt/sh/zonal.h"

namespace shprt {
namespace {

bool isGreyColour(Vec3f colour) {
  return colour.x == colour.y && colour.y == colour.z;
}

}  // namespace

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

double unshadowedNorm(int degree) {
  std::vector<double> transfer(static_cast<std::size_t>(coefficientCount(degree)));
  UnshadowedTransfer(degree).evaluate({0, 0, 1}, transfer);
  return std::sqrt(std::inner_product(transfer.begin(), transfer.end(), transfer.begin(), 0.0));
}

bool isGrey(const Scene& scene) {
  if (!std::all_of(scene.albedo.begin(), scene.albedo.end(), isGreyColour)) return false;
  return std::all_of(scene.textures.begin(), scene.textures.end(), [](const Image& texture) {
    return std::all_of(texture.pixels.begin(), texture.pixels.end(), isGreyColour);
  });
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
  const bool grey = std::all_of(albedo.begin(), albedo.end(), isGreyColour);
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
