// Band 0 of the transfer is albedo / pi times the integral of visibility times cosine times y_00, so
// visibility is sqrt(4 pi) times it over albedo.

#include "shprt/report/asset_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "shprt/sh/basis.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {
namespace {

double bandEnergy(const TransferCoefficients& transfer, int l) {
  double sum = 0;
  for (int channel = 0; channel < transfer.channels; ++channel)
    for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i) {
      const float* row = transfer.row(channel, i);
      for (std::size_t v = 0; v < transfer.vertexCount; ++v)
        sum += static_cast<double>(row[v]) * static_cast<double>(row[v]);
    }
  return sum / (static_cast<double>(transfer.vertexCount) * transfer.channels);
}

void measureVisibility(const TransferAsset& asset, AssetStatistics& statistics) {
  const TransferCoefficients& transfer = asset.transfer;
  double sum = 0, least = std::numeric_limits<double>::infinity(), most = 0;
  std::size_t count = 0;
  for (std::size_t v = 0; v < transfer.vertexCount; ++v) {
    const Vec3f& albedo = asset.albedo[v];
    // The brightest channel says it with the fewest rounded digits.
    const std::array<float, 3> channels = {albedo.x, albedo.y, albedo.z};
    const auto brightest =
        static_cast<int>(std::max_element(channels.begin(), channels.end()) - channels.begin());
    const auto reflected = static_cast<double>(channels[static_cast<std::size_t>(brightest)]);
    if (!(reflected > 0)) continue;
    const float* row = transfer.row(transfer.channels == 1 ? 0 : brightest, 0);
    const double visibility = std::sqrt(4 * std::numbers::pi) * static_cast<double>(row[v]) / reflected;
    sum += visibility;
    least = std::min(least, visibility);
    most = std::max(most, visibility);
    ++count;
  }
  if (count == 0) return;
  statistics.meanVisibility = sum / static_cast<double>(count);
  statistics.minimumVisibility = least;
  statistics.maximumVisibility = most;
}

void measureEmission(const std::vector<Vec3f>& emission, AssetStatistics& statistics) {
  if (emission.empty()) return;
  float least = std::numeric_limits<float>::infinity(), most = -least;
  std::size_t lit = 0;
  for (const Vec3f& radiance : emission) {
    const auto [low, high] = std::minmax({radiance.x, radiance.y, radiance.z});
    least = std::min(least, low);
    most = std::max(most, high);
    lit += high > 0;
  }
  statistics.minimumEmission = least;
  statistics.maximumEmission = most;
  statistics.emissionShare = static_cast<double>(lit) / static_cast<double>(emission.size());
}

double squaredNorm(const Vec3f& v) {
  const Vec3d wide = toDouble(v);
  return dot(wide, wide);
}

double sumOfSquares(const std::vector<Vec3f>& vectors) {
  double sum = 0;
  for (const Vec3f& v : vectors) sum += squaredNorm(v);
  return sum;
}

void measureErrors(const TransferAsset& asset, AssetStatistics& statistics) {
  const TransferError& error = asset.error;
  if (error.empty()) return;
  double squares = 0;
  for (const float value : error.values) squares += static_cast<double>(value) * static_cast<double>(value);
  squares /= error.channels;
  // The unshadowed transfer of every normal has the same norm, times albedo.
  const double unshadowed = std::pow(unshadowedNorm(error.degree), 2) * sumOfSquares(asset.albedo) / 3;
  if (unshadowed > 0) statistics.transferError = std::sqrt(squares / unshadowed);
  const double emission = sumOfSquares(asset.emission);
  if (!asset.emissionError.empty() && emission > 0)
    statistics.emissionError = std::sqrt(sumOfSquares(asset.emissionError) / emission);
}

}  // namespace

AssetStatistics measureAsset(const TransferAsset& asset) {
  AssetStatistics statistics;
  const auto [low, high] = std::minmax_element(asset.transfer.values.begin(), asset.transfer.values.end());
  if (low == asset.transfer.values.end()) return statistics;
  statistics.minimum = *low;
  statistics.maximum = *high;
  for (int l = 0; l <= asset.transfer.degree; ++l)
    statistics.bandEnergy.push_back(bandEnergy(asset.transfer, l));
  measureVisibility(asset, statistics);
  measureEmission(asset.emission, statistics);
  measureErrors(asset, statistics);
  return statistics;
}

}  // namespace shprt
