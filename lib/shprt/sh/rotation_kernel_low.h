// The rotation of the lowest bands, unrolled: sums of a few terms where vectors would be mostly padding.
// Compiled like rotation_kernel.h. Band 1 is the matrix itself in the order y, z, x.

#include "shprt/sh/rotation_kernel_turns.h"
#include "shprt/sh/rotation_variants.h"

namespace shprt {
namespace {

// Cosines and sines of m times the three angles, side by side.
using ThreeTurns = double __attribute__((vector_size(32)));

struct LowTurns {
  ThreeTurns cosine[kScalarLowDegree + 1], sine[kScalarLowDegree + 1];
};

inline void turnPair(const LowTurns& turns, int turn, int m, double& cosine, double& sine) {
  const double c = turns.cosine[m][turn], s = turns.sine[m][turn], plus = cosine;
  cosine = c * plus - s * sine;
  sine = s * plus + c * sine;
}

// rows x columns, read row by row; constants moves on.
template <int kRows, int kColumns>
inline void multiply(const double*& constants, const double* from, double* to) {
#pragma GCC unroll 8
  for (int row = 0; row < kRows; ++row) {
    double sum = constants[0] * from[0];
#pragma GCC unroll 8
    for (int column = 1; column < kColumns; ++column) sum += constants[column] * from[column];
    constants += kColumns;
    to[row] = sum;
  }
}

// Band kL. The y_l0 entry's missing sine is left out of the products, so one sine group is one shorter.
template <int kL>
inline void rotateUnrolledBand(const double*& constants, const LowTurns& turns, double* set) {
  constexpr int kParity = kL % 2, kEven = kL / 2 + 1, kOdd = (kL + 1) / 2;
  constexpr int kEvenSkip = 1 - kParity, kOddSkip = kParity;  // sines left out
  double* const band = set + kL * (kL + 1);
  double evenCosines[kEven], evenSines[kEven], oddCosines[kOdd], oddSines[kOdd];
#pragma GCC unroll 8
  for (int i = 0; i < kEven; ++i)
    evenCosines[i] = band[kParity + 2 * i], evenSines[i] = band[-kParity - 2 * i];
#pragma GCC unroll 8
  for (int i = 0; i < kOdd; ++i)
    oddCosines[i] = band[1 - kParity + 2 * i], oddSines[i] = band[kParity - 1 - 2 * i];
  const double* const swap = constants;
#pragma GCC unroll 3
  for (int turn = 0; turn < 3; ++turn) {
    if (turn > 0) {
      double turned[4][kEven];
      constants = swap;
      multiply<kEven, kEven>(constants, evenCosines, turned[0]);
      multiply<kEven - kEvenSkip, kOdd>(constants, oddCosines, turned[1]);
      multiply<kOdd, kEven - kEvenSkip>(constants, evenSines + kEvenSkip, turned[2]);
      multiply<kOdd - kOddSkip, kOdd - kOddSkip>(constants, oddSines + kOddSkip, turned[3]);
#pragma GCC unroll 8
      for (int i = 0; i < kEven; ++i) evenCosines[i] = turned[0][i];
#pragma GCC unroll 8
      for (int i = kEvenSkip; i < kEven; ++i) evenSines[i] = turned[1][i - kEvenSkip];
#pragma GCC unroll 8
      for (int i = 0; i < kOdd; ++i) oddCosines[i] = turned[2][i];
#pragma GCC unroll 8
      for (int i = kOddSkip; i < kOdd; ++i) oddSines[i] = turned[3][i - kOddSkip];
    }
#pragma GCC unroll 8
    for (int i = kEvenSkip; i < kEven; ++i)
      turnPair(turns, turn, kParity + 2 * i, evenCosines[i], evenSines[i]);
#pragma GCC unroll 8
    for (int i = kOddSkip; i < kOdd; ++i)
      turnPair(turns, turn, 1 - kParity + 2 * i, oddCosines[i], oddSines[i]);
  }
#pragma GCC unroll 8
  for (int i = kEvenSkip; i < kEven; ++i) band[-kParity - 2 * i] = evenSines[i];
#pragma GCC unroll 8
  for (int i = kOddSkip; i < kOdd; ++i) band[kParity - 1 - 2 * i] = oddSines[i];
#pragma GCC unroll 8
  for (int i = 0; i < kEven; ++i) band[kParity + 2 * i] = evenCosines[i];
#pragma GCC unroll 8
  for (int i = 0; i < kOdd; ++i) band[1 - kParity + 2 * i] = oddCosines[i];
}

void rotateLowKernel(int degree, const UnrolledSwaps& swaps, const Mat3& matrix, double* set) {
  if (degree < 1) return;
  rotateFirstBand(matrix, set);
  if (degree < 2) return;
  rotateSecondBand(matrix, set);
  if (degree < 3) return;
  const ZTurns angles = zTurns(matrix);
  LowTurns turns;
  turns.cosine[1] = ThreeTurns{angles.turns[0].c, angles.turns[1].c, angles.turns[2].c, 1};
  turns.sine[1] = ThreeTurns{angles.turns[0].s, angles.turns[1].s, angles.turns[2].s, 0};
  // By halves, which keeps the chain of dependent products short.
#pragma GCC unroll 8
  for (int m = 2; m <= kScalarLowDegree; ++m) {
    const int a = m / 2, b = m - a;
    turns.cosine[m] = turns.cosine[a] * turns.cosine[b] - turns.sine[a] * turns.sine[b];
    turns.sine[m] = turns.sine[a] * turns.cosine[b] + turns.cosine[a] * turns.sine[b];
  }
  const double* constants = swaps.scalars;
  rotateUnrolledBand<3>(constants, turns, set);
  if (degree < 4) return;
  rotateUnrolledBand<4>(constants, turns, set);
  if (degree < 5) return;
  rotateUnrolledBand<5>(constants, turns, set);
}

}  // namespace
}  // namespace shprt
