// All randomness of the project: a counter-based generator, so that a seed and an index fix every number
// whatever the order or the thread that asks.
#pragma once

#include <cstdint>

namespace shprt {

// A well-mixed 64-bit hash of one counter under one seed.
// Based on: Steele, Lea and Flood 2014 (SplitMix64), its output function applied twice.
constexpr std::uint64_t hashCounter(std::uint64_t seed, std::uint64_t counter) {
  constexpr auto mix = [](std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  };
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;
  return mix(mix(seed + kGolden) + (counter + 1) * kGolden);
}

// Uniform in [0, 1), dimension `dimension` of the random point that belongs to (seed, index). At most 256
// dimensions.
constexpr double uniformRandom(std::uint64_t seed, std::uint64_t index, unsigned dimension) {
  return static_cast<double>(hashCounter(seed, index * 256 + dimension) >> 11) * 0x1p-53;
}

}  // namespace shprt
