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

// A point of the unit square.
struct SquarePoint {
  double u, v;
};

// Independent and uniform in [0, 1)^2 for every counter under one key, on a grid of 2^-32. For as many
// numbers as one likes under a (seed, index), take hashCounter(seed, index) as the key.
constexpr SquarePoint randomPoint(std::uint64_t key, std::uint64_t counter) {
  const std::uint64_t bits = hashCounter(key, counter);
  return {static_cast<double>(bits >> 32) * 0x1p-32, static_cast<double>(bits & 0xffffffffu) * 0x1p-32};
}

}  // namespace shprt
