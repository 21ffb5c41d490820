// Rotation as three turns about z between two exchanges of y and z: Rz(alpha) Ry(beta) Rz(gamma) with
// Ry(beta) = P Rz(-beta) P, where P exchanges y and z. Based on: Pinchon and Hoggan 2007 (the one fixed
// matrix). The cosines and sines of the turns come from the matrix without any angle: each from entries that
// determine it even where the others are lost (gimbal lock).

#include "shprt/sh/rotation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>

#include "shprt/base/error.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/processor.h"
#include "shprt/sh/rotation_kernel_turns.h"
#include "shprt/sh/rotation_swap.h"
#include "shprt/sh/rotation_turns.h"
#include "shprt/sh/rotation_variants.h"

namespace shprt {
namespace {

// Whether a matrix that is a rotation to rounding needs only turns of the pairs (m, -m).
bool isTurnAboutZ(const Mat3& matrix) {
  return matrix.m[0][2] == 0 && matrix.m[1][2] == 0 && matrix.m[2][2] > 0;
}

// band points at its m = 0 entry.
void turnBandAboutZ(int l, const TurnPowers& powers, double* band) {
  for (int m = 1; m <= l; ++m) {
    const auto [c, s] = powers[m];
    const double plus = band[m], minus = band[-m];
    band[m] = c * plus - s * minus;
    band[-m] = s * plus + c * minus;
  }
}

// The unpadded order of the unrolled kernel.
UnrolledSwaps unrollSwaps() {
  UnrolledSwaps unrolled{};
  double* next = unrolled.scalars;
  for (int l = 3; l <= kScalarLowDegree; ++l) {
    const SwapBand& swap = cachedSwapBand(l);
    const int evenSkip = 1 - l % 2, oddSkip = l % 2;  // y_l0 has no sine
    const auto copy = [&next](const double* block, int stride, int firstRow, int rows, int firstColumn,
                              int columns) {
      for (int row = firstRow; row < rows; ++row)
        for (int column = firstColumn; column < columns; ++column) *next++ = block[column * stride + row];
    };
    copy(swap.evenCosines, swap.evenStride, 0, swap.even, 0, swap.even);
    copy(swap.evenSines, swap.evenStride, evenSkip, swap.even, 0, swap.odd);
    copy(swap.oddCosines, swap.oddStride, 0, swap.odd, evenSkip, swap.even);
    copy(swap.oddSines, swap.oddStride, oddSkip, swap.odd, oddSkip, swap.odd);
  }
  assert(next == unrolled.scalars + std::size(unrolled.scalars));
  for (int l = 2; l <= kVectorLowDegree; ++l) {
    const SwapBand& swap = cachedSwapBand(l);
    double* column = unrolled.lanes[l];
    const auto copyColumn = [&column](const double* upper, int upperCount, const double* lower,
                                      int lowerCount) {
      std::copy_n(upper, upperCount, column);
      std::copy_n(lower, lowerCount, column + 4);
      column += 8;
    };
    for (int k = 0; k < swap.even; ++k)
      copyColumn(swap.evenCosines + k * swap.evenStride, swap.even, swap.oddCosines + k * swap.oddStride,
                 swap.odd);
    for (int k = 0; k < swap.odd; ++k)
      copyColumn(swap.evenSines + k * swap.evenStride, swap.even, swap.oddSines + k * swap.oddStride,
                 swap.odd);
  }
  return unrolled;
}

}  // namespace

const UnrolledSwaps& unrolledSwaps() {
  static const UnrolledSwaps unrolled = unrollSwaps();
  return unrolled;
}

const RotationVariant& chooseRotationVariant() {
#if defined(__x86_64__)
  if (hasAvx512()) return kRotationAvx512;
  if (hasAvx2()) return kRotationAvx2;
#endif
  return kRotationBaseline;
}

ShRotation::ShRotation(int degree, const Mat3& matrix) : degree_(degree), matrix_(matrix) {
  if (degree < 0 || degree > kMaximumRotationDegree)
    throw Error("rotation", "the degree " + std::to_string(degree) + " is out of range",
                "use 0 to " + std::to_string(kMaximumRotationDegree));
  if (rotationVariant().isRotationToRounding(matrix)) return;
  const NearestRotation nearest = nearestRotation(matrix);
  correction_ = nearest.correction;
  matrix_ = nearest.rotation;
}

void ShRotation::apply(std::span<double> set) const {
  assert(set.size() == static_cast<std::size_t>(coefficientCount(degree_)));
  const RotationVariant& variant = rotationVariant();
  if (degree_ > variant.lowDegree || isTurnAboutZ(matrix_)) return apply(std::span(&set, 1));
  variant.rotateLow(degree_, unrolledSwaps(), matrix_, set.data());
}

void ShRotation::apply(std::span<const std::span<double>> sets) const {
  if (isTurnAboutZ(matrix_)) {
    if (matrix_.m[0][0] == 1) return;
    const TurnPowers powers(degree_, zTurns(matrix_).turns[0]);
    for (const std::span<double> set : sets)
      for (int l = 1; l <= degree_; ++l) turnBandAboutZ(l, powers, set.data() + shIndex(l, 0));
    return;
  }
  const RotationVariant& variant = rotationVariant();
  for (const std::span<double> set : sets) {
    assert(set.size() == static_cast<std::size_t>(coefficientCount(degree_)));
    variant.rotateLow(std::min(degree_, variant.lowDegree), unrolledSwaps(), matrix_, set.data());
  }
  if (degree_ <= variant.lowDegree) return;
  const TurnWorkspace workspace(degree_, zTurns(matrix_).turns);
  SwapBand uncached;
  for (int l = variant.lowDegree + 1; l <= degree_; ++l) {
    if (l > kMaximumCachedSwapBand) buildSwapBand(l, uncached);
    const SwapBand& swap = l > kMaximumCachedSwapBand ? uncached : cachedSwapBand(l);
    for (const std::span<double> set : sets)
      variant.rotateBand(swap, workspace.tables(), workspace.scratch(), set.data() + shIndex(l, 0));
  }
}

void ShRotation::applyToBand(int l, std::span<const std::span<double>> bands) const {
  assert(l >= 0 && l <= degree_);
  const RotationVariant& variant = rotationVariant();
  if (isTurnAboutZ(matrix_)) {
    const TurnPowers powers(l, zTurns(matrix_).turns[0]);
    for (const std::span<double> band : bands) turnBandAboutZ(l, powers, band.data() + l);
  } else if (l <= variant.lowDegree) {
    for (const std::span<double> band : bands) {
      double set[coefficientCount(kVectorLowDegree)] = {};
      std::copy(band.begin(), band.end(), set + shIndex(l, -l));
      variant.rotateLow(l, unrolledSwaps(), matrix_, set);
      std::copy_n(set + shIndex(l, -l), band.size(), band.begin());
    }
  } else {
    const TurnWorkspace workspace(l, zTurns(matrix_).turns);
    SwapBand uncached;
    if (l > kMaximumCachedSwapBand) buildSwapBand(l, uncached);
    const SwapBand& swap = l > kMaximumCachedSwapBand ? uncached : cachedSwapBand(l);
    for (const std::span<double> band : bands)
      variant.rotateBand(swap, workspace.tables(), workspace.scratch(), band.data() + l);
  }
}

}  // namespace shprt
