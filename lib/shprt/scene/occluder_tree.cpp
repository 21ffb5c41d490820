#include "shprt/scene/occluder_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "shprt/base/box.h"
#include "shprt/base/parallel.h"

namespace shprt {
namespace {

// What rounding a bound to float may lose, relative to it.
constexpr double kRounding = 1e-6;
constexpr std::size_t kBlock = 1024;

struct Bounds {
  Vec3f center, half, axis;
  float offset = 0, thickness = 0;
  Vec3d areaNormal;  // the sum of the triangles', twice their area long
};

float roundedUp(double value) {
  return static_cast<float>(value * (1 + kRounding) + std::numeric_limits<double>::min());
}

Vec3d lowest(Vec3d a, Vec3d b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3d highest(Vec3d a, Vec3d b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
double boxReach(Vec3d direction, Vec3f half) {
  return std::abs(direction.x) * static_cast<double>(half.x) +
         std::abs(direction.y) * static_cast<double>(half.y) +
         std::abs(direction.z) * static_cast<double>(half.z);
}

// The scalar twin of reach().
double reachOf(const Bounds& bounds, Vec3d n) {
  const Vec3d axis = toDouble(bounds.axis);
  const double k = dot(n, axis);
  return std::min(boxReach(n, bounds.half), k * static_cast<double>(bounds.offset) +
                                                std::abs(k) * static_cast<double>(bounds.thickness) +
                                                boxReach(n - axis * k, bounds.half));
}

void setBox(Bounds& bounds, Vec3d low, Vec3d high) {
  bounds.center = toFloat((low + high) * 0.5);
  const Vec3d half = highest(high - toDouble(bounds.center), toDouble(bounds.center) - low);
  bounds.half = {roundedUp(half.x), roundedUp(half.y), roundedUp(half.z)};
  bounds.axis = toFloat(normalize(bounds.areaNormal));
}

// low, high: bounds of axis . (q - center).
void setSlab(Bounds& bounds, double low, double high) {
  bounds.offset = static_cast<float>((low + high) * 0.5);
  const double offset = static_cast<double>(bounds.offset);
  bounds.thickness = roundedUp(std::max(high - offset, offset - low));
}

Bounds boundTriangles(std::span<const OccluderTree::Corners> triangles) {
  Bounds bounds;
  Vec3d low = toDouble(triangles[0].a), high = low;
  for (const auto& [a, b, c] : triangles) {
    for (const Vec3f corner : {a, b, c}) {
      low = lowest(low, toDouble(corner));
      high = highest(high, toDouble(corner));
    }
    bounds.areaNormal += cross(toDouble(b) - toDouble(a), toDouble(c) - toDouble(a));
  }
  setBox(bounds, low, high);
  double slabLow = std::numeric_limits<double>::infinity(), slabHigh = -slabLow;
  for (const auto& [a, b, c] : triangles)
    for (const Vec3f corner : {a, b, c}) {
      const double along = dot(toDouble(bounds.axis), toDouble(corner) - toDouble(bounds.center));
      slabLow = std::min(slabLow, along);
      slabHigh = std::max(slabHigh, along);
    }
  setSlab(bounds, slabLow, slabHigh);
  return bounds;
}

Bounds boundNodes(std::span<const Bounds> nodes) {
  Bounds bounds;
  Vec3d low = toDouble(nodes[0].center), high = low;
  for (const Bounds& node : nodes) {
    low = lowest(low, toDouble(node.center) - toDouble(node.half));
    high = highest(high, toDouble(node.center) + toDouble(node.half));
    bounds.areaNormal += node.areaNormal;
  }
  setBox(bounds, low, high);
  const Vec3d axis = toDouble(bounds.axis);
  double slabLow = std::numeric_limits<double>::infinity(), slabHigh = -slabLow;
  for (const Bounds& node : nodes) {
    const double along = dot(axis, toDouble(node.center) - toDouble(bounds.center));
    slabLow = std::min(slabLow, along - reachOf(node, -axis));
    slabHigh = std::max(slabHigh, along + reachOf(node, axis));
  }
  setSlab(bounds, slabLow, slabHigh);
  return bounds;
}

void setLane(OccluderTree::Lanes3& lanes, std::size_t lane, Vec3f value) {
  lanes.x[lane] = value.x;
  lanes.y[lane] = value.y;
  lanes.z[lane] = value.z;
}

OccluderTree::Group groupNodes(std::span<const Bounds> nodes) {
  OccluderTree::Group group{};
  for (std::size_t lane = 0; lane < nodes.size(); ++lane) {
    setLane(group.center, lane, nodes[lane].center);
    setLane(group.half, lane, nodes[lane].half);
    setLane(group.axis, lane, nodes[lane].axis);
    group.offset[lane] = nodes[lane].offset;
    group.thickness[lane] = nodes[lane].thickness;
  }
  return group;
}

// Puts two zero bits before each of the lowest ten.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 16) & 0x030000ffu;
  bits = (bits | bits << 8) & 0x0300f00fu;
  bits = (bits | bits << 4) & 0x030c30c3u;
  return (bits | bits << 2) & 0x09249249u;
}

// Sorts by the 30 bits above the lowest 32, in place; equal ones keep their order.
void sortByCode(std::vector<std::uint64_t>& keys) {
  constexpr std::size_t kDigits = 1024;
  std::vector<std::uint64_t> sorted(keys.size());
  for (const int shift : {32, 42, 52}) {
    std::array<std::size_t, kDigits + 1> starts{};
    const auto digit = [shift](std::uint64_t key) {
      return static_cast<std::size_t>(key >> shift) % kDigits;
    };
    for (const std::uint64_t key : keys) ++starts[digit(key) + 1];
    for (std::size_t d = 0; d < kDigits; ++d) starts[d + 1] += starts[d];
    for (const std::uint64_t key : keys) sorted[starts[digit(key)]++] = key;
    keys.swap(sorted);
  }
}

// The numbers of the triangles along a Morton curve through their middles.
std::vector<std::uint32_t> mortonOrder(std::span<const Vec3f> positions,
                                       std::span<const std::array<std::uint32_t, 3>> triangles) {
  const Box box = boxAround(positions);
  const Vec3f low = toFloat(box.low);
  const auto extent = static_cast<float>(box.extent());
  // A third of a cell count, for sums of three corners.
  const float cells = extent > 0 ? 1023.0f / 3 / extent : 0;
  std::vector<std::uint64_t> keys(triangles.size());
  parallelForBlocks(keys.size(), 4 * kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& [a, b, c] = triangles[i];
      const Vec3f cell = ((positions[a] - low) + (positions[b] - low) + (positions[c] - low)) * cells;
      const std::uint64_t code = spread(static_cast<std::uint32_t>(cell.x)) |
                                 spread(static_cast<std::uint32_t>(cell.y)) << 1 |
                                 spread(static_cast<std::uint32_t>(cell.z)) << 2;
      keys[i] = code << 32 | i;
    }
  });
  sortByCode(keys);
  std::vector<std::uint32_t> order(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = static_cast<std::uint32_t>(keys[i]);
  return order;
}

}  // namespace

OccluderTree::OccluderTree(std::span<const Vec3f> positions,
                           std::span<const std::array<std::uint32_t, 3>> triangles)
    : positions_(positions), meshTriangles_(triangles) {
  assert(!triangles.empty());
  triangles_ = mortonOrder(positions, triangles);
  std::vector<Bounds> nodes((triangles.size() + kWidth - 1) / kWidth);
  parallelForBlocks(nodes.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) {
      const std::size_t first = node * kWidth, count = std::min(kWidth, triangles_.size() - first);
      std::array<Corners, kWidth> below;
      for (std::size_t k = 0; k < count; ++k) below[k] = corners(first + k);
      nodes[node] = boundTriangles(std::span(below).first(count));
    }
  });
  for (;;) {
    const std::size_t groups = (nodes.size() + kWidth - 1) / kWidth, first = groups_.size();
    levels_.push_back({first, nodes.size()});
    groups_.resize(first + groups);
    std::vector<Bounds> parents(groups);
    parallelForBlocks(groups, kBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t group = begin; group < end; ++group) {
        const auto children = std::span<const Bounds>(nodes).subspan(
            group * kWidth, std::min(kWidth, nodes.size() - group * kWidth));
        groups_[first + group] = groupNodes(children);
        parents[group] = boundNodes(children);
      }
    });
    if (groups == 1) break;
    nodes = std::move(parents);
  }
}

}  // namespace shprt
