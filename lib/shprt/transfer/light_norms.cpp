#include "shprt/transfer/light_norms.h"

#include <cmath>

#include "shprt/base/parallel.h"

namespace shprt {

std::vector<BandNorm> bandNorms(const LightRows& light, const LightLayout& layout,
                                const SurfaceTopology& topology, std::span<const std::uint32_t> receivers) {
  constexpr std::size_t kBlock = 4096;
  const std::size_t points = topology.pointCount();
  const auto bands = static_cast<std::size_t>(layout.bandCount());
  // Sums of squares per block, then over blocks in order: the same bits whatever the threads.
  std::vector<std::vector<BandNorm>> partial((points + kBlock - 1) / kBlock, std::vector<BandNorm>(bands));
  parallelForBlocks(points, kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t point = begin; point < end; ++point) {
      const double ofReceivers = receivers[point],
                   ofAll = static_cast<double>(topology.verticesOfPoint(point).size());
      const float* row = light.row(point);
      for (std::size_t i = 0; i < bands; ++i) {
        const LightLayout::Band band = layout.band(static_cast<int>(i));
        double squares = 0;
        for (std::size_t column = band.first; column < band.end; ++column)
          squares += static_cast<double>(row[column]) * static_cast<double>(row[column]);
        partial[begin / kBlock][i].receivers += ofReceivers * squares;
        partial[begin / kBlock][i].all += ofAll * squares;
      }
    }
  });
  double receiverCount = 0;
  for (const std::uint32_t count : receivers) receiverCount += count;
  const auto vertexCount = static_cast<double>(topology.pointIds().size());
  std::vector<BandNorm> norms(bands);
  for (std::size_t i = 0; i < bands; ++i) {
    BandNorm sum;
    for (const auto& block : partial) sum.receivers += block[i].receivers, sum.all += block[i].all;
    norms[i] = {receiverCount > 0 ? std::sqrt(sum.receivers / receiverCount) : 0,
                std::sqrt(sum.all / vertexCount)};
  }
  return norms;
}

}  // namespace shprt
