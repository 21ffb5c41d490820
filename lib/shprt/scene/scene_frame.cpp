#include "shprt/scene/scene_frame.h"

#include <cmath>
#include <cstddef>

#include "shprt/base/box.h"

namespace shprt {
namespace {

// A shift along one axis that is exact for every coordinate in [low, high]: the bound nearer to zero, when
// the interval lies so far from zero that low and high are within a factor of two.
double exactShift(double low, double high) {
  if (low > 0 && high <= 2 * low) return low;
  if (high < 0 && low >= 2 * high) return high;
  return 0;
}

}  // namespace

SceneFrame chooseSceneFrame(std::span<const Vec3f> positions) {
  const Box box = boxAround(positions);
  const auto [low, high] = box;
  SceneFrame frame;
  frame.offset = {exactShift(low.x, high.x), exactShift(low.y, high.y), exactShift(low.z, high.z)};
  const double extent = box.extent();
  if (extent > 0) frame.scale = std::ldexp(1.0, -std::ilogb(extent));
  return frame;
}

std::vector<Vec3f> toScene(const SceneFrame& frame, std::span<const Vec3f> positions) {
  std::vector<Vec3f> moved(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) moved[i] = frame.toScene(positions[i]);
  return moved;
}

}  // namespace shprt
