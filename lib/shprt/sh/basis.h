// Real orthonormal spherical harmonics: indexing and evaluation.
//
// Convention (docs/conventions.md): the integral of y_i y_j over the sphere is 1 when i = j and 0 otherwise;
// flat index l(l+1)+m; no Condon-Shortley phase, so y_{1,-1}, y_{1,0}, y_{1,1} are sqrt(3/4pi) times y, z, x;
// m > 0 carries cos(m phi), m < 0 sin(|m| phi). `degree` is the highest l, always.
#pragma once

#include <cassert>
#include <span>

#include "shprt/base/vec.h"

namespace shprt {

inline constexpr int kMaximumBakeDegree =
    32;  // of stored transfer and probes; evaluation itself goes far beyond

constexpr int coefficientCount(int degree) {
  return (degree + 1) * (degree + 1);
}
constexpr int shIndex(int l, int m) {
  return l * (l + 1) + m;
}
// The band l that a flat index belongs to.
constexpr int bandOf(int index) {
  int l = 0;
  while ((l + 1) * (l + 1) <= index) ++l;
  return l;
}

// Writes y_i(direction) for all i < coefficientCount(degree). direction is of unit length; results has at
// least that many entries. Double precision; error at most 3e-13 sqrt((2l+1)/4pi) to l = 100, 2e-11 to l =
// 1000, poles included. The reference for all vectorised twins.
void evaluateSh(int degree, Vec3d direction, std::span<double> results);

}  // namespace shprt
