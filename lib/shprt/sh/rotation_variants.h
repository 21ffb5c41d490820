// The instruction-set variants of the rotation kernels, for their dispatch and for the tests that compare
// them.
#pragma once

#include <cstddef>

#include "shprt/sh/rotation.h"
#include "shprt/sh/rotation_swap.h"

namespace shprt {

// Cosines and sines of m times an angle, split by the parity of m (m at m / 2) and padded as bands are.
struct TurnTable {
  const double* cosine[2];
  const double* sine[2];
};

// The three turns about z in the order in which they are applied: gamma, -beta, alpha.
struct TurnTables {
  TurnTable turns[3];
};

// Doubles of scratch that a band with strides of at most `stride` takes: eight groups.
constexpr std::size_t bandScratch(int stride) {
  return 8 * static_cast<std::size_t>(stride);
}

inline constexpr int kScalarLowDegree = 5, kVectorLowDegree = 7;

// The exchange of y and z in the lowest bands, in the orders of the kernels for them.
struct UnrolledSwaps {
  // Bands 3 to kScalarLowDegree, block after block in rows, without the missing sine of y_l0.
  double scalars[13 + 21 + 31];
  // Per band to kVectorLowDegree: columns of eight for cosines (four of the even group from even cosines,
  // four of the odd group from even sines), then those for sines.
  alignas(64) double lanes[kVectorLowDegree + 1][(kVectorLowDegree + 1) * 8];
};
const UnrolledSwaps& unrolledSwaps();

struct RotationVariant {
  const char* name;
  int lowDegree;
  bool (*isRotationToRounding)(const Mat3& matrix);
  // Rotates bands 0 to degree <= lowDegree of one set by a matrix that is a rotation.
  void (*rotateLow)(int degree, const UnrolledSwaps& swaps, const Mat3& matrix, double* set);
  // Rotates one band; band points at its m = 0 entry, scratch at bandScratch() doubles, aligned to a cache
  // line.
  void (*rotateBand)(const SwapBand& swap, const TurnTables& tables, double* scratch, double* band);
  // to row i = sum over k < size of matrix[k * size + i] times from row k, for sets [0, setCount); rows are
  // stride apart. pastCaches: results are too many to stay in the caches. scratch: 2 * size * kManyBlock
  // floats, aligned to a cache line.
  void (*rotateManyBand)(int size, const float* matrix, const float* from, float* to, std::size_t setCount,
                         std::size_t stride, bool pastCaches, float* scratch);
};

// Sets that rotateManyBand takes at a time.
inline constexpr std::size_t kManyBlock = 256;

extern const RotationVariant kRotationBaseline;
#if defined(__x86_64__)
extern const RotationVariant kRotationAvx2;
extern const RotationVariant kRotationAvx512;
void rotateLowAvx512(int degree, const UnrolledSwaps& swaps, const Mat3& matrix, double* set);
#endif

// The fastest that this processor runs.
const RotationVariant& chooseRotationVariant();
// That choice, made once.
inline const RotationVariant& rotationVariant() {
  static const RotationVariant& chosen = chooseRotationVariant();
  return chosen;
}

}  // namespace shprt
