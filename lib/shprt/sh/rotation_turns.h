// Cosines and sines of the multiples m of an angle, from its cosine and sine alone.
#pragma once

#include <cstddef>
#include <vector>

#include "shprt/sh/rotation.h"
#include "shprt/sh/rotation_swap.h"
#include "shprt/sh/rotation_variants.h"

namespace shprt {

// Steps through (c + i s)^m. What c^2 + s^2 lacks to 1 by rounding is put back to first order, so only the
// rounding of single steps remains and grows like a random walk: about 1e-16 sqrt(m).
class TurnStepper {
 public:
  explicit TurnStepper(CosineSine turn);
  // To the next m, from m = 0.
  void step() {
    const double c = current_.c * turn_.c - current_.s * turn_.s;
    const double s = current_.s * turn_.c + current_.c * turn_.s;
    current_ = {c + lack_ * c, s + lack_ * s};
  }
  CosineSine current() const { return current_; }

 private:
  CosineSine turn_, current_;
  double lack_;  // 1 / |c + i s| - 1
};

class TurnPowers {
 public:
  TurnPowers(int degree, CosineSine turn);
  CosineSine operator[](int m) const { return powers_[static_cast<std::size_t>(m)]; }

 private:
  std::vector<CosineSine> powers_;
};

// The tables and the scratch that rotateBand takes for bands to a degree; on the stack to degree 32.
class TurnWorkspace {
 public:
  TurnWorkspace(int degree, const CosineSine turns[3]);
  TurnWorkspace(const TurnWorkspace&) = delete;
  TurnWorkspace& operator=(const TurnWorkspace&) = delete;
  const TurnTables& tables() const { return tables_; }
  double* scratch() const { return scratch_; }

 private:
  static constexpr int kNearStride = 24;
  static constexpr std::size_t kNear = 12 * kNearStride + bandScratch(kNearStride);

  TurnTables tables_;
  double* scratch_;
  std::vector<SwapBand::Line> far_;
  alignas(64) double near_[kNear];
};

}  // namespace shprt
