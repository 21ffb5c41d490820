// Sets of cosine-distributed directions over the hemisphere, as every point of a bake traces them.
//
// Each set is unbiased: whatever its count, the mean of a function over its directions has the expectation of
// that function under the density cos(theta)/pi, and each (seed, index) draws anew. What tells them apart is
// how evenly the directions lie (docs/accuracy.md has their errors).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "shprt/base/vec.h"

namespace shprt {

enum class PointSet {
  kLattice,   // Fibonacci lattice, shifted at random for each index (fibonacci_hemisphere.h): what bakes use
  kSobol,     // (0,2) Sobol sequence, Owen-scrambled anew for each index
  kJittered,  // one point at random in each cell of a grid
  kRandom,    // independent points
};

// "lattice", "sobol", "jittered", "random".
const char* pointSetName(PointSet set);

class HemisphereSet {
 public:
  virtual ~HemisphereSet() = default;

  int count() const { return static_cast<int>(quarters().size()); }
  // count() rounded up to whole groups; the directions beyond count() repeat the last one.
  virtual std::size_t paddedCount() const = 0;

  // Unit directions in world space around unit `normal` for the vertex that (seed, index) names, as three
  // arrays of paddedCount() floats; none of them below the horizon. The order is that of every call.
  virtual void directions(Vec3d normal, std::uint64_t seed, std::uint64_t index, float* x, float* y,
                          float* z) const = 0;

  // Per direction, 0 to 3: the quarter of the set it belongs to. Quarters 0 and 1, and 2 and 3, are the
  // set's halves. Each of them is a set of the same kind but coarser, as even as such a cut can be; the sizes
  // of quarters, and of halves, differ by at most one.
  //
  // For the means Q0..Q3 over the quarters and Q over the set, the sum of (Qi - Q)^2 / 12 has at least the
  // expectation of Q's squared error. So has (A - B)^2 / 4 for the halves, but for the lattice only on
  // average over functions: to some its halves err alike (tests/sampling/quarters_test.cpp).
  virtual std::span<const std::uint8_t> quarters() const = 0;

  // Per direction, 0 to 15: its quarter's four quarters, cut in the same way; divided by 4 it is the quarter.
  virtual std::span<const std::uint8_t> sixteenths() const = 0;
};

// The quarter of the i-th of points that are dealt out in turn, so that neighbours in the sequence are in
// different halves.
constexpr std::uint8_t quarterInTurn(std::size_t i) {
  return static_cast<std::uint8_t>(2 * (i % 2) + i / 2 % 2);
}
constexpr std::uint8_t sixteenthInTurn(std::size_t i) {
  return static_cast<std::uint8_t>(4 * quarterInTurn(i) + quarterInTurn(i / 4));
}

// count >= 1. Directions are ordered so that neighbours are in the same group of `groupSize`, where the set
// allows it.
std::unique_ptr<HemisphereSet> makeHemisphereSet(PointSet set, int count, int groupSize);

}  // namespace shprt
