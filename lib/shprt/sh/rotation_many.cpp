// Many coefficient sets by one rotation: the dense matrix of each band, built once, in single precision.

#include <cassert>
#include <vector>

#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"
#include "shprt/sh/rotation_variants.h"

namespace shprt {
namespace {

struct alignas(64) FloatLine {
  float entries[16];
};

}  // namespace

void rotateMany(const ShRotation& rotation, const float* from, float* to, std::size_t setCount,
                std::size_t stride) {
  assert(setCount <= stride);
  // More than this is not read again before it has left the caches of one core.
  constexpr std::size_t kCacheBytes = std::size_t{4} << 20;
  const int degree = rotation.degree();
  const std::size_t bytes = setCount * static_cast<std::size_t>(coefficientCount(degree)) * sizeof(float);
  const std::size_t largest = 2 * static_cast<std::size_t>(degree) + 1;
  std::vector<FloatLine> scratch(2 * largest * kManyBlock * sizeof(float) / sizeof(FloatLine));
  std::vector<float> columns;
  for (int l = 0; l <= degree; ++l) {
    const auto size = static_cast<std::size_t>(2 * l + 1);
    const std::vector<double> matrix = wignerMatrix(l, rotation.matrix());
    columns.resize(matrix.size());
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k) columns[k * size + i] = static_cast<float>(matrix[i * size + k]);
    const std::size_t row = static_cast<std::size_t>(shIndex(l, -l)) * stride;
    rotationVariant().rotateManyBand(2 * l + 1, columns.data(), from + row, to + row, setCount, stride,
                                     bytes > kCacheBytes, scratch.front().entries);
  }
}

}  // namespace shprt
