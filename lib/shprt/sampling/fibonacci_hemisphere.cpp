#include "shprt/sampling/fibonacci_hemisphere.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "shprt/base/frame.h"
#include "shprt/sampling/hemisphere.h"
#include "shprt/sampling/neighbour_order.h"
#include "shprt/sampling/random.h"

namespace shprt {
namespace {

double fraction(double turns) {
  return turns - std::floor(turns);
}

// Cuts points by the next binary digit of their number i, and those of the same digit by that of the whole
// turns in i / golden ratio, which tells in which half of 2 * turns turns they lie; the median there, instead
// of the middle, makes the quarters equal. step: 1, or 2 for points that were cut so before.
std::array<std::vector<std::size_t>, 4> cutLattice(const std::vector<std::size_t>& points, std::size_t step) {
  std::array<std::vector<std::size_t>, 4> quarters;
  const auto inTurns = [step](std::size_t i) {
    return fraction(static_cast<double>(i) / (2 * static_cast<double>(step) * std::numbers::phi));
  };
  for (std::size_t digit = 0; digit < 2; ++digit) {
    std::vector<std::size_t> half;
    for (const std::size_t i : points)
      if (i / step % 2 == digit) half.push_back(i);
    const auto median = half.begin() + static_cast<std::ptrdiff_t>((half.size() + 1) / 2);
    std::nth_element(half.begin(), median, half.end(),
                     [&](std::size_t a, std::size_t b) { return inTurns(a) < inTurns(b); });
    quarters[2 * digit].assign(half.begin(), median);
    quarters[2 * digit + 1].assign(median, half.end());
  }
  return quarters;
}

std::vector<std::uint8_t> latticeSixteenths(int count) {
  std::vector<std::size_t> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<std::uint8_t> sixteenths(all.size());
  const auto quarters = cutLattice(all, 1);
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    const auto parts = cutLattice(quarters[quarter], 2);
    for (std::size_t part = 0; part < 4; ++part)
      for (const std::size_t i : parts[part]) sixteenths[i] = static_cast<std::uint8_t>(4 * quarter + part);
  }
  return sixteenths;
}

}  // namespace

FibonacciHemisphere::FibonacciHemisphere(int count, int groupSize) {
  assert(count >= 1 && groupSize >= 1);
  const auto azimuth = [](int i) { return 2 * std::numbers::pi * fraction(i / std::numbers::phi); };
  std::vector<DiscPoint> points;
  for (int i = 0; i < count; ++i) {
    const double radius = std::sqrt((i + 0.5) / count);
    points.push_back({radius * std::cos(azimuth(i)), radius * std::sin(azimuth(i))});
  }
  const std::vector<int> order = orderByNeighbours(points, groupSize);
  const std::vector<std::uint8_t> sixteenths = latticeSixteenths(count);
  for (const int i : order) {
    sixteenths_.push_back(sixteenths[static_cast<std::size_t>(i)]);
    quarters_.push_back(sixteenths_.back() / 4);
  }
  for (std::size_t slot = 0; slot < wholeGroups(count, groupSize); ++slot) {
    const int i = order[std::min(slot, order.size() - 1)];
    cosines_.push_back(static_cast<float>(std::cos(azimuth(i))));
    sines_.push_back(static_cast<float>(std::sin(azimuth(i))));
    rings_.push_back(static_cast<float>(static_cast<double>(i) / count));
  }
}

void FibonacciHemisphere::directions(Vec3d normal, std::uint64_t seed, std::uint64_t index, float* x,
                                     float* y, float* z) const {
  const double turn = 2 * std::numbers::pi * uniformRandom(seed, index, 1);
  const Frame frame = frameFromNormal(normal);
  const Vec3f a = toFloat(frame.tangent * std::cos(turn) + frame.bitangent * std::sin(turn));
  const Vec3f b = toFloat(frame.bitangent * std::cos(turn) - frame.tangent * std::sin(turn));
  const Vec3f c = toFloat(normal);
  const float offset = static_cast<float>(uniformRandom(seed, index, 0) / count());
  for (std::size_t i = 0; i < cosines_.size(); ++i) {
    const float u = std::min(rings_[i] + offset, kLargestRing);
    const float radius = std::sqrt(u);
    const float height = std::sqrt(1 - u);
    const float localX = radius * cosines_[i], localY = radius * sines_[i];
    x[i] = a.x * localX + b.x * localY + c.x * height;
    y[i] = a.y * localX + b.y * localY + c.y * height;
    z[i] = a.z * localX + b.z * localY + c.z * height;
  }
}

}  // namespace shprt
