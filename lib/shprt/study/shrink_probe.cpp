#include "shprt/study/shrink_probe.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "shprt/base/parallel.h"
#include "shprt/image/cube_layout.h"

namespace shprt {
namespace {

// Pixels of the picture that a pixel of the small one covers, and how much of each, along one side.
struct Cover {
  int begin = 0, end = 0;
  double low = 0, high = 0;

  Cover(int index, int smallSide, int side)
      : low(static_cast<double>(index) * side / smallSide),
        high(static_cast<double>(index + 1) * side / smallSide) {
    begin = static_cast<int>(low);
    end = std::min(static_cast<int>(std::ceil(high)), side);
  }
  double share(int pixel) const { return std::min(high, pixel + 1.0) - std::max(low, double(pixel)); }
};

Vec3f coveredMean(const EnvironmentMap& map, const std::vector<double>& solidAngles, const Cover& across,
                  const Cover& down) {
  Vec3d sum;
  double weights = 0;
  bool any = false;
  for (int y = down.begin; y < down.end; ++y)
    for (int x = across.begin; x < across.end; ++x) {
      const double weight =
          across.share(x) * down.share(y) *
          solidAngles[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.image.width) +
                      static_cast<std::size_t>(x)];
      if (!(weight > 0)) continue;
      any = true;
      const Vec3f& pixel = map.image.at(x, y);
      if (!isFinite(pixel)) continue;
      sum = sum + toDouble(pixel) * weight;
      weights += weight;
    }
  if (weights > 0) return toFloat(sum * (1 / weights));
  const float nothing = any ? std::numeric_limits<float>::quiet_NaN() : 0;
  return {nothing, nothing, nothing};
}

}  // namespace

EnvironmentMap shrinkProbe(const EnvironmentMap& map, int factor) {
  assert(factor >= 1);
  const int width = map.image.width, height = map.image.height;
  const auto cells = isCube(map.layout) ? cubeCells(map.layout) : CubeCells{1, 1};
  EnvironmentMap small{.image = {},
                       .layout = map.layout,
                       .layoutReason = map.layoutReason,
                       .notes = map.notes,
                       .sources = map.sources};
  small.image.width = cells.columns * std::max(width / cells.columns / factor, 1);
  small.image.height = cells.rows * std::max(height / cells.rows / factor, 1);
  small.image.pixels.resize(static_cast<std::size_t>(small.image.width) *
                            static_cast<std::size_t>(small.image.height));

  std::vector<double> solidAngles(map.image.pixels.size());
  parallelForBlocks(static_cast<std::size_t>(height), 16, [&](std::size_t begin, std::size_t end) {
    for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < width; ++x)
        solidAngles[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)] = pixelFootprint(map.layout, width, height, x, y).solidAngle;
  });
  parallelForBlocks(static_cast<std::size_t>(small.image.height), 4, [&](std::size_t begin, std::size_t end) {
    for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < small.image.width; ++x)
        small.image.at(x, y) = coveredMean(map, solidAngles, Cover(x, small.image.width, width),
                                           Cover(y, small.image.height, height));
  });
  return small;
}

}  // namespace shprt
