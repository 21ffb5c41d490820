#include "shprt/transfer/ray_allocation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "shprt/transfer/edge_smoothing.h"
#include "shprt/transfer/ray_plan.h"

namespace shprt {
namespace {

constexpr double kUnseenShare = 0.01;
constexpr int kNearSmoothings = 2, kWideSmoothings = 14;

// What is known of a point from one pass: weighted square of what quarters differ by, and those that tell the
// rate.
constexpr std::size_t kColumns = 3;
enum Column { kSquare, kQuarter, kSixteenth };

}  // namespace

RayAllocator::RayAllocator(const PointErrors& errors, const SurfaceTopology& topology,
                           std::span<const Vec3d> weights, double unshadowedSquare, double mostExponent)
    : points_(weights.size()) {
  std::vector<float> evidence(weights.size() * kColumns);
  std::vector<std::uint8_t> isExact(weights.size());
  double weightSum = 0, tracedWeight = 0, squareSum = 0;
  for (std::size_t point = 0; point < weights.size(); ++point) {
    const double weight = weights[point].x + weights[point].y + weights[point].z;
    weightSum += weight;
    isExact[point] = errors.rays[point] == 0;
    if (isExact[point]) continue;
    tracedWeight += weight;
    const double square = weightedSquare(errors, errors.squares, point, weights[point]);
    squareSum += square;
    // Comparable whatever the rays, and whatever the weight.
    const double scale = std::pow(static_cast<double>(errors.rays[point]), mostExponent);
    float* row = &evidence[point * kColumns];
    row[kSquare] = static_cast<float>(weight > 0 ? scale * square / weight : 0);
    row[kQuarter] = static_cast<float>(scale * static_cast<double>(errors.quarters[point]));
    row[kSixteenth] = static_cast<float>(scale * static_cast<double>(errors.sixteenths[point]));
  }
  if (!(squareSum > 0)) return;
  smoothOverEdges(topology, isExact, kNearSmoothings, kColumns, evidence);
  std::vector<float> wide = evidence;
  smoothOverEdges(topology, isExact, kWideSmoothings, kColumns, wide);

  for (std::size_t point = 0; point < weights.size(); ++point) {
    Point& known = points_[point];
    known.isExact = isExact[point];
    const double weight = weights[point].x + weights[point].y + weights[point].z;
    if (known.isExact || weight == 0) continue;
    const auto mean = [&](Column column) {
      return 0.5 * static_cast<double>(evidence[point * kColumns + column] + wide[point * kColumns + column]);
    };
    const double ratio = mean(kQuarter) > 0 ? mean(kSixteenth) / mean(kQuarter) : 4;
    const double exponent = std::clamp(std::log2(ratio) / 2, 1.0, mostExponent);
    const double rays = errors.rays[point];
    const double square =
        mean(kSquare) * std::pow(rays, -mostExponent) + kUnseenShare * squareSum / tracedWeight;
    const double variance = weight * square / (weightSum * unshadowedSquare);
    known.exponent = static_cast<float>(exponent);
    known.logVariance = static_cast<float>(std::log2(variance) + exponent * std::log2(rays));
    known.slope = static_cast<float>(1 / (exponent + 1));
    known.level = known.slope * (known.logVariance + static_cast<float>(std::log2(exponent))) -
                  static_cast<float>(std::log2(RayPlan::kLeastRays));
  }
}

RayAllocation RayAllocator::allocate(double price) const {
  RayAllocation allocation;
  allocation.levels.resize(points_.size());
  double sum = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Point& point = points_[i];
    int level = 0;
    if (point.slope > 0) {
      const double ideal = static_cast<double>(point.level) + static_cast<double>(point.slope) * price;
      level = static_cast<int>(std::clamp<double>(std::round(ideal), 0, RayPlan::kLevels - 1));
      sum += std::exp2(point.logVariance -
                       point.exponent * std::log2(static_cast<float>(RayPlan::raysOfLevel(level))));
    }
    allocation.levels[i] = static_cast<std::uint8_t>(level);
    if (!point.isExact) allocation.rays += RayPlan::raysOfLevel(level);
  }
  allocation.error = std::sqrt(sum);
  return allocation;
}

// The least price that is enough, to a hundredth of a doubling.
template <class Enough>
RayAllocation RayAllocator::search(const Enough& isEnough) const {
  // Beyond these nothing changes: squared errors are below 2^40, and above 2^-160 those that a price
  // could be paid for.
  double low = -100, high = 400;
  RayAllocation best = allocate(high);
  while (high - low > 0.01) {
    const double middle = 0.5 * (low + high);
    RayAllocation allocation = allocate(middle);
    if (isEnough(allocation)) {
      high = middle;
      best = std::move(allocation);
    } else {
      low = middle;
    }
  }
  return best;
}

RayAllocation RayAllocator::forError(double error) const {
  return search([&](const RayAllocation& allocation) { return allocation.error <= error; });
}

RayAllocation RayAllocator::forRays(double rays) const {
  // The least that is too much, and a step back.
  RayAllocation best = allocate(-std::numeric_limits<double>::max());
  search([&](const RayAllocation& allocation) {
    if (allocation.rays > rays) return true;
    if (allocation.rays > best.rays) best = allocation;
    return false;
  });
  return best;
}

}  // namespace shprt
