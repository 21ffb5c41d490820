// From a rotation matrix to the three turns about z, and band 1, which is the matrix itself. Compiled once
// for each instruction set, like rotation_kernel.h.
#pragma once

#include "shprt/sh/rotation.h"

namespace shprt {
namespace {

// Turns by gamma, -beta and alpha of R = Rz(alpha) Ry(beta) Rz(gamma), in the order in which they are
// applied.
struct ZTurns {
  CosineSine turns[3];
};

// Each pair comes from entries that determine it even where the others are lost (gimbal lock).
inline ZTurns zTurns(const Mat3& matrix) {
  const auto& r = matrix.m;
  const double squared = r[0][2] * r[0][2] + r[1][2] * r[1][2];
  CosineSine alpha, minusBeta;
  // Below, squares leave the range of double; a tilt of 1e-140 is none.
  if (squared > 1e-280) {
    // Side by side, where a division by the root would wait for it.
    const double tilt = __builtin_sqrt(squared), inverse = tilt * (1 / squared);
    alpha = {r[0][2] * inverse, r[1][2] * inverse};
    minusBeta = {r[2][2], -tilt};
  } else {
    minusBeta = {r[2][2] > 0 ? 1.0 : -1.0, 0};
  }
  const CosineSine gamma = {alpha.c * r[1][1] - alpha.s * r[0][1], alpha.c * r[1][0] - alpha.s * r[0][0]};
  return {{gamma, minusBeta, alpha}};
}

// Rotates the entries of y, z, x that follow the constant of a set.
inline void rotateFirstBand(const Mat3& matrix, double* set) {
  const auto& r = matrix.m;
  const double y = set[1], z = set[2], x = set[3];
  set[1] = r[1][0] * x + r[1][1] * y + r[1][2] * z;
  set[2] = r[2][0] * x + r[2][1] * y + r[2][2] * z;
  set[3] = r[0][0] * x + r[0][1] * y + r[0][2] * z;
}

// Rotates the five entries of band 2, as the traceless symmetric matrix Q of the quadratic form that they
// are: Q becomes R Q R^T. Up to one factor the basis is h xy, h yz, (3 z^2 - 1) / 4, h xz and h (x^2 - y^2) /
// 2 with h = sqrt(3) / 2.
inline void rotateSecondBand(const Mat3& matrix, double* set) {
  constexpr double kH = 0.86602540378443864676, kInverse = 1.1547005383792515290;
  double* const a = set + 6;
  const double xy = kH * a[-2], yz = kH * a[-1], zz = a[0], xz = kH * a[1];
  const double xx = kH * a[2] - zz / 2, yy = -kH * a[2] - zz / 2;
  double rotated[3][3];  // R Q
  for (int i = 0; i < 3; ++i) {
    const double* const row = matrix.m[i];
    rotated[i][0] = row[0] * xx + row[1] * xy + row[2] * xz;
    rotated[i][1] = row[0] * xy + row[1] * yy + row[2] * yz;
    rotated[i][2] = row[0] * xz + row[1] * yz + row[2] * zz;
  }
  const auto& r = matrix.m;
  const auto& t = rotated;
  a[-2] = kInverse * (t[0][0] * r[1][0] + t[0][1] * r[1][1] + t[0][2] * r[1][2]);
  a[-1] = kInverse * (t[1][0] * r[2][0] + t[1][1] * r[2][1] + t[1][2] * r[2][2]);
  a[0] = t[2][0] * r[2][0] + t[2][1] * r[2][1] + t[2][2] * r[2][2];
  a[1] = kInverse * (t[0][0] * r[2][0] + t[0][1] * r[2][1] + t[0][2] * r[2][2]);
  a[2] = kInverse / 2 *
         ((t[0][0] * r[0][0] + t[0][1] * r[0][1] + t[0][2] * r[0][2]) -
          (t[1][0] * r[1][0] + t[1][1] * r[1][1] + t[1][2] * r[1][2]));
}

// Whether a matrix is a rotation to the rounding of its entries; a quick yes before nearestRotation judges.
// Lanes 0 to 2 count: the squares of columns, their products in turn, and the cross product of two rows.
inline bool isRotationToRounding(const Mat3& matrix) {
  using Lanes = double __attribute__((vector_size(32)));
  Lanes row0, row1, last;
  __builtin_memcpy(&row0, matrix.m[0], sizeof row0);
  __builtin_memcpy(&row1, matrix.m[1], sizeof row1);
  __builtin_memcpy(&last, &matrix.m[1][2], sizeof last);  // ends where the matrix does
  const Lanes row2 = __builtin_shufflevector(last, last, 1, 2, 3, 3);
  const Lanes next0 = __builtin_shufflevector(row0, row0, 1, 2, 0, 3);
  const Lanes next1 = __builtin_shufflevector(row1, row1, 1, 2, 0, 3);
  const Lanes next2 = __builtin_shufflevector(last, last, 2, 3, 1, 3);
  const Lanes squares = row0 * row0 + row1 * row1 + row2 * row2 - 1.0;
  const Lanes products = row0 * next0 + row1 * next1 + row2 * next2;
  const Lanes cross = row0 * next1 - next0 * row1 - __builtin_shufflevector(last, last, 3, 1, 2, 3);
  const Lanes worst = squares * squares + products * products + cross * cross;
  constexpr double kBound = 1e-15 * 1e-15;  // false for what is no number
  return worst[0] <= kBound && worst[1] <= kBound && worst[2] <= kBound;
}

}  // namespace
}  // namespace shprt
