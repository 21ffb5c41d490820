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

// Writes y_i(u / |u|) for all i < coefficientCount(degree), u = direction, finite and not zero; results has
// at least that many entries. No degree is too high. Double precision; for a direction whose length is 1 to
// rounding the error is at most 1e-14 sqrt((2l+1)/4pi) to l = 100 and 3e-14 sqrt((2l+1)/4pi) to l = 1000,
// poles, equator and any tilt included. Other lengths cost a division, whose rounding turns the direction: an
// error of 1e-16 l sqrt((2l+1)/4pi) more. Values below 1e-150 may come out as zero, never as subnormal
// numbers. The reference for all vectorised twins.
void evaluateSh(int degree, Vec3d direction, std::span<double> results);

}  // namespace shprt
