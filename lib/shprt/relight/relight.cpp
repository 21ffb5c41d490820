#include "shprt/relight/relight.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

// Vertices per block: their sums in double stay in the first-level cache while the rows stream past once.
constexpr std::size_t kBlock = 2048;

// sums[colour][v] += sum over rows of light[colour][row] * row[v], for the colours that share these rows
// (one, or all three of a grey asset). Four rows at a time, so that the sums are loaded a quarter as often.
template <int kColours>
void addRows(const TransferCoefficients& transfer, int channel, std::size_t begin, std::size_t count,
             const std::vector<double>* light, double (*sums)[kBlock]) {
  const auto rows = static_cast<int>(light[0].size());
  int i = 0;
  for (; i + 4 <= rows; i += 4) {
    const float* a = transfer.row(channel, i) + begin;
    const float* b = transfer.row(channel, i + 1) + begin;
    const float* c = transfer.row(channel, i + 2) + begin;
    const float* d = transfer.row(channel, i + 3) + begin;
    for (std::size_t v = 0; v < count; ++v) {
      const double da = static_cast<double>(a[v]), db = static_cast<double>(b[v]),
                   dc = static_cast<double>(c[v]), dd = static_cast<double>(d[v]);
      for (int colour = 0; colour < kColours; ++colour) {
        const double* l = &light[colour][static_cast<std::size_t>(i)];
        sums[colour][v] += l[0] * da + l[1] * db + l[2] * dc + l[3] * dd;
      }
    }
  }
  for (; i < rows; ++i) {
    const float* a = transfer.row(channel, i) + begin;
    for (int colour = 0; colour < kColours; ++colour)
      for (std::size_t v = 0; v < count; ++v)
        sums[colour][v] += light[colour][static_cast<std::size_t>(i)] * static_cast<double>(a[v]);
  }
}

}  // namespace

std::vector<Vec3f> relight(const TransferCoefficients& transfer, const LightCoefficients& light) {
  const int rows = coefficientCount(std::min(transfer.degree, light.degree));
  // One array of coefficients per colour, as the sums take them.
  std::vector<double> channelLight[3];
  for (int colour = 0; colour < 3; ++colour)
    for (int i = 0; i < rows; ++i) {
      channelLight[colour].push_back(
          light.coefficients[static_cast<std::size_t>(i)][static_cast<std::size_t>(colour)]);
    }
  std::vector<Vec3f> radiance(transfer.vertexCount);
  parallelForBlocks(transfer.vertexCount, kBlock, [&](std::size_t begin, std::size_t end) {
    double sums[3][kBlock] = {};
    if (transfer.channels == 1) {
      addRows<3>(transfer, 0, begin, end - begin, channelLight, sums);
    } else {
      for (int colour = 0; colour < 3; ++colour)
        addRows<1>(transfer, colour, begin, end - begin, &channelLight[colour], &sums[colour]);
    }
    for (std::size_t v = begin; v < end; ++v) {
      radiance[v] = toFloat({sums[0][v - begin], sums[1][v - begin], sums[2][v - begin]});
    }
  });
  return radiance;
}

std::vector<Vec3f> relight(const TransferAsset& asset, const LightCoefficients& light, double emissionScale) {
  std::vector<Vec3f> radiance = relight(asset.transfer, light);
  if (asset.emission.empty()) return radiance;
  assert(asset.emission.size() == radiance.size() && emissionScale >= 0);
  parallelForBlocks(radiance.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      radiance[v] = toFloat(toDouble(radiance[v]) + toDouble(asset.emission[v]) * emissionScale);
  });
  return radiance;
}

}  // namespace shprt
