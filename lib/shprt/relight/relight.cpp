#include "shprt/relight/relight.h"

#include <algorithm>
#include <cstddef>

#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

// Vertices per block: their sums in double stay in the first-level cache while the rows stream past once.
constexpr std::size_t kBlock = 2048;

// sums[v] += sum over rows of light[row] * row[v]. Four rows at a time, so that the sums are loaded a quarter as often.
void addRows(const TransferCoefficients& transfer, int channel, std::size_t begin, std::size_t count, const double* light,
             int rows, double* sums) {
  int i = 0;
  for (; i + 4 <= rows; i += 4) {
    const float* a = transfer.row(channel, i) + begin;
    const float* b = transfer.row(channel, i + 1) + begin;
    const float* c = transfer.row(channel, i + 2) + begin;
    const float* d = transfer.row(channel, i + 3) + begin;
    const double la = light[i], lb = light[i + 1], lc = light[i + 2], ld = light[i + 3];
    for (std::size_t v = 0; v < count; ++v) {
      sums[v] += la * static_cast<double>(a[v]) + lb * static_cast<double>(b[v]) + lc * static_cast<double>(c[v]) +
                 ld * static_cast<double>(d[v]);
    }
  }
  for (; i < rows; ++i) {
    const float* a = transfer.row(channel, i) + begin;
    for (std::size_t v = 0; v < count; ++v) sums[v] += light[i] * static_cast<double>(a[v]);
  }
}

}  // namespace

std::vector<Vec3f> relight(const TransferCoefficients& transfer, const LightCoefficients& light) {
  const int rows = coefficientCount(std::min(transfer.degree, light.degree));
  // One array of coefficients per colour, as the sums take them.
  std::vector<double> channelLight[3];
  for (int colour = 0; colour < 3; ++colour)
    for (int i = 0; i < rows; ++i) {
      channelLight[colour].push_back(light.coefficients[static_cast<std::size_t>(i)][static_cast<std::size_t>(colour)]);
    }
  std::vector<Vec3f> radiance(transfer.vertexCount);
  parallelForBlocks(transfer.vertexCount, kBlock, [&](std::size_t begin, std::size_t end) {
    double sums[3][kBlock] = {};
    for (int colour = 0; colour < 3; ++colour) {
      const int channel = transfer.channels == 1 ? 0 : colour;
      addRows(transfer, channel, begin, end - begin, channelLight[colour].data(), rows, sums[colour]);
    }
    for (std::size_t v = begin; v < end; ++v) {
      radiance[v] = toFloat({sums[0][v - begin], sums[1][v - begin], sums[2][v - begin]});
    }
  });
  return radiance;
}

}  // namespace shprt
