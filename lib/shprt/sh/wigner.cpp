// The Wigner matrix of one band: its columns are the rotated unit vectors.

#include <cassert>
#include <vector>

#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"

namespace shprt {

std::vector<double> wignerMatrix(int l, const Mat3& rotation) {
  const ShRotation rotate(l, rotation);
  const auto size = static_cast<std::size_t>(2 * l + 1);
  std::vector<double> columns(size * size), matrix(size * size);
  std::vector<std::span<double>> sets;
  for (std::size_t n = 0; n < size; ++n) {
    columns[n * size + n] = 1;
    sets.emplace_back(&columns[n * size], size);
  }
  rotate.applyToBand(l, sets);
  for (std::size_t m = 0; m < size; ++m)
    for (std::size_t n = 0; n < size; ++n) matrix[m * size + n] = columns[n * size + m];
  return matrix;
}

}  // namespace shprt
