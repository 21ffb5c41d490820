#include "shprt/scene/position_ids.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <numeric>

namespace shprt {
namespace {

template <std::size_t N>
std::vector<std::uint32_t> numberDistinct(std::size_t count, const auto& keyOf) {
  using Key = std::array<std::uint32_t, N>;
  constexpr std::uint32_t kEmpty = 0xffffffffu;
  // Open addressing in a table at most half full: one array of numbers, no node allocations.
  const std::size_t capacity = std::bit_ceil(std::max<std::size_t>(16, 2 * count));
  std::vector<std::uint32_t> table(capacity, kEmpty);
  std::vector<std::uint32_t> ids(count);
  std::vector<std::uint32_t> firstUse;
  for (std::size_t i = 0; i < count; ++i) {
    const Key key = keyOf(i);
    std::uint64_t hash = 0;
    for (const std::uint32_t word : key) hash = (std::rotl(hash, 23) ^ word) * 0x9e3779b97f4a7c15u;
    std::size_t slot = (hash ^ (hash >> 32)) & (capacity - 1);
    while (table[slot] != kEmpty && keyOf(firstUse[table[slot]]) != key) slot = (slot + 1) & (capacity - 1);
    if (table[slot] == kEmpty) {
      table[slot] = static_cast<std::uint32_t>(firstUse.size());
      firstUse.push_back(static_cast<std::uint32_t>(i));
    }
    ids[i] = table[slot];
  }
  return ids;
}

// Adding zero turns -0 into 0.
std::uint32_t bitsOf(float value) { return std::bit_cast<std::uint32_t>(value + 0.0f); }

}  // namespace

std::vector<std::uint32_t> distinctPositionIds(std::span<const Vec3f> positions) {
  return numberDistinct<3>(positions.size(), [&](std::size_t i) {
    const Vec3f p = positions[i];
    return std::array{bitsOf(p.x), bitsOf(p.y), bitsOf(p.z)};
  });
}

std::vector<std::uint32_t> distinctPointIds(std::span<const Vec3f> positions, std::span<const Vec3f> normals) {
  assert(positions.size() == normals.size());
  return numberDistinct<6>(positions.size(), [&](std::size_t i) {
    const Vec3f p = positions[i], n = normals[i];
    return std::array{bitsOf(p.x), bitsOf(p.y), bitsOf(p.z), bitsOf(n.x), bitsOf(n.y), bitsOf(n.z)};
  });
}

}  // namespace shprt
