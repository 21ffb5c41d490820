// The first two dimensions of Sobol's sequence under Owen's nested uniform scrambling.
//
// The sequence is a (0,2)-sequence in base 2: of each 2^m consecutive points from a multiple of 2^m on, every
// elementary interval of area 2^-m (dyadic, of whatever shape) holds exactly one. Scrambling exchanges the
// two halves of an interval or not, by a coin for every node of the binary tree of each axis: that keeps this
// property, makes each point uniform, and so each mean over points unbiased.
//
// The first 2^m points differ in the first m bits of each coordinate. Below these, a node has one point at
// most, whose further bits are coins of its own: exactly nested scrambling takes 2^m - 1 shared coins per
// axis, and a random number per point.
//
// Based on: Sobol 1967 (the sequence), Owen 1995 (the scrambling).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shprt/sampling/random.h"

namespace shprt {

class ScrambledSobol {
 public:
  // The first `count` >= 1 points of the sequence.
  explicit ScrambledSobol(int count);

  int count() const { return count_; }
  // m, the least with 2^m >= count().
  int bits() const { return bits_; }
  // The first bits() bits of the coordinates before scrambling, for i in [0, 2^bits()).
  std::uint32_t cellU(std::uint32_t i) const;
  std::uint32_t cellV(std::uint32_t i) const;

  // A scrambling of its own for every key. Fills `points` with point i of the sequence at [i].
  void scramble(std::uint64_t key, std::vector<SquarePoint>& points) const;

 private:
  int count_, bits_;
};

}  // namespace shprt
