#include "shprt/sampling/fibonacci_hemisphere.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "shprt/base/frame.h"
#include "shprt/sampling/random.h"

namespace shprt {
namespace {

struct DiscPoint {
  int index;
  double x, y;
};

// Halves a range at a multiple of the group size, across its longer side, until groups remain.
void groupNeighbours(std::span<DiscPoint> points, std::size_t groupSize) {
  if (points.size() <= groupSize) return;
  const auto [xLow, xHigh] =
      std::minmax_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.x < b.x; });
  const auto [yLow, yHigh] =
      std::minmax_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.y < b.y; });
  const bool splitX = xHigh->x - xLow->x > yHigh->y - yLow->y;
  const std::size_t groups = (points.size() + groupSize - 1) / groupSize;
  const std::size_t half = (groups / 2) * groupSize;
  std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(half), points.end(),
                   [splitX](const DiscPoint& a, const DiscPoint& b) {
                     const double keyA = splitX ? a.x : a.y, keyB = splitX ? b.x : b.y;
                     return keyA != keyB ? keyA < keyB : a.index < b.index;
                   });
  groupNeighbours(points.first(half), groupSize);
  groupNeighbours(points.subspan(half), groupSize);
}

}  // namespace

FibonacciHemisphere::FibonacciHemisphere(int count, int groupSize) : count_(count) {
  assert(count >= 1 && groupSize >= 1);
  std::vector<DiscPoint> points;
  points.reserve(static_cast<std::size_t>(count));
  const auto azimuth = [](int i) {
    const double turns = i / std::numbers::phi;
    return 2 * std::numbers::pi * (turns - std::floor(turns));
  };
  for (int i = 0; i < count; ++i) {
    const double radius = std::sqrt((i + 0.5) / count);
    points.push_back({i, radius * std::cos(azimuth(i)), radius * std::sin(azimuth(i))});
  }
  groupNeighbours(points, static_cast<std::size_t>(groupSize));
  while (points.size() % static_cast<std::size_t>(groupSize) != 0) points.push_back(points.back());
  for (const DiscPoint& point : points) {
    cosines_.push_back(static_cast<float>(std::cos(azimuth(point.index))));
    sines_.push_back(static_cast<float>(std::sin(azimuth(point.index))));
    rings_.push_back(static_cast<float>(static_cast<double>(point.index) / count));
  }
}

void FibonacciHemisphere::directions(Vec3d normal, std::uint64_t seed, std::uint64_t index, float* x,
                                     float* y, float* z) const {
  const double turn = 2 * std::numbers::pi * uniformRandom(seed, index, 1);
  const Frame frame = frameFromNormal(normal);
  const Vec3f a = toFloat(frame.tangent * std::cos(turn) + frame.bitangent * std::sin(turn));
  const Vec3f b = toFloat(frame.bitangent * std::cos(turn) - frame.tangent * std::sin(turn));
  const Vec3f c = toFloat(normal);
  const float offset = static_cast<float>(uniformRandom(seed, index, 0) / count_);
  for (std::size_t i = 0; i < cosines_.size(); ++i) {
    // Rounding may push the outermost ring to the horizon or past it; a ray stays above.
    const float u = std::min(rings_[i] + offset, 0.99999994f);
    const float radius = std::sqrt(u);
    const float height = std::sqrt(1 - u);
    const float localX = radius * cosines_[i], localY = radius * sines_[i];
    x[i] = a.x * localX + b.x * localY + c.x * height;
    y[i] = a.y * localX + b.y * localY + c.y * height;
    z[i] = a.z * localX + b.z * localY + c.z * height;
  }
}

}  // namespace shprt
