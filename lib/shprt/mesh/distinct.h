// Numbering distinct keys in order of first use, with one flat table and no allocation per key.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shprt {

struct DistinctIds {
  std::vector<std::uint32_t> ids;       // per item, the number of its key
  std::vector<std::uint32_t> firstUse;  // per number, the first item that has it
};

// keyOf(item) gives std::array<std::uint32_t, N>; it is called again whenever keys are compared.
template <std::size_t N, typename KeyOf>
DistinctIds numberDistinct(std::size_t count, const KeyOf& keyOf) {
  using Key = std::array<std::uint32_t, N>;
  constexpr std::uint32_t kEmpty = 0xffffffffu;
  const std::size_t capacity = std::bit_ceil(std::max<std::size_t>(16, 2 * count));  // at most half full
  std::vector<std::uint32_t> table(capacity, kEmpty);
  DistinctIds distinct;
  distinct.ids.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Key key = keyOf(i);
    std::uint64_t hash = 0;
    for (const std::uint32_t word : key) hash = (std::rotl(hash, 23) ^ word) * 0x9e3779b97f4a7c15u;
    std::size_t slot = (hash ^ (hash >> 32)) & (capacity - 1);
    while (table[slot] != kEmpty && keyOf(distinct.firstUse[table[slot]]) != key)
      slot = (slot + 1) & (capacity - 1);
    if (table[slot] == kEmpty) {
      table[slot] = static_cast<std::uint32_t>(distinct.firstUse.size());
      distinct.firstUse.push_back(static_cast<std::uint32_t>(i));
    }
    distinct.ids[i] = table[slot];
  }
  return distinct;
}

// Adding zero turns -0 into 0, which is the same place.
inline std::uint32_t keyBits(float value) {
  return std::bit_cast<std::uint32_t>(value + 0.0f);
}

}  // namespace shprt
