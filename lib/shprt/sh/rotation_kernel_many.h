// Many coefficient sets by one dense matrix, vectorised over sets. Compiled like rotation_kernel.h. A block
// of results is made in the first cache and leaves it row by row, past the caches where lines are whole:
// then a result costs memory one write, as in a copy.

#include "shprt/sh/rotation_variants.h"

namespace shprt {
namespace {

using Floats = float __attribute__((vector_size(SHPRT_LANE_BYTES)));
constexpr std::size_t kFloats = SHPRT_LANE_BYTES / 4;
// Sets between what is worked on and what is fetched: rows are far apart, which hides them from prefetchers.
constexpr std::size_t kPrefetchAhead = 512;

// Rows [row, row + kRows) of the product for one vector of sets.
template <int kRows>
inline void multiplyRows(int size, const float* matrix, const float* from, std::size_t stride, float* to) {
  Floats sums[kRows];
  for (int row = 0; row < kRows; ++row) sums[row] = Floats{};
  for (int k = 0; k < size; ++k) {
    Floats entry;
    __builtin_memcpy(&entry, from + static_cast<std::size_t>(k) * stride, sizeof entry);
    for (int row = 0; row < kRows; ++row) sums[row] += entry * matrix[k * size + row];
  }
  for (int row = 0; row < kRows; ++row)
    __builtin_memcpy(to + static_cast<std::size_t>(row) * kManyBlock, &sums[row], sizeof sums[row]);
}

// The last rows, fewer than a tile, in one pass.
template <int kRows>
inline void multiplyLastRows(int size, int rows, const float* matrix, const float* from, std::size_t stride,
                             float* to) {
  if constexpr (kRows > 0) {
    if (rows == kRows) {
      multiplyRows<kRows>(size, matrix, from, stride, to);
    } else {
      multiplyLastRows<kRows - 1>(size, rows, matrix, from, stride, to);
    }
  }
}

inline void multiplyVector(int size, const float* matrix, const float* from, std::size_t stride, float* to) {
  constexpr int kTile = SHPRT_LANE_BYTES == 64 ? 9 : 5;
  int row = 0;
  for (; row + kTile <= size; row += kTile)
    multiplyRows<kTile>(size, matrix + row, from, stride, to + static_cast<std::size_t>(row) * kManyBlock);
  multiplyLastRows<kTile - 1>(size, size - row, matrix + row, from, stride,
                              to + static_cast<std::size_t>(row) * kManyBlock);
}

inline void streamOut(const float* from, std::size_t count, float* to) {
  std::size_t i = 0;
#if defined(SHPRT_STREAM)
  const auto misplaced = reinterpret_cast<unsigned long long>(to) % 64 / 4;
  if (count >= 32) {
    for (const std::size_t head = (16 - misplaced) % 16; i < head; ++i) to[i] = from[i];
    for (; i + 16 <= count; i += 16)
      for (std::size_t part = 0; part < 16; part += kFloats) {
        Floats lanes;
        __builtin_memcpy(&lanes, from + i + part, sizeof lanes);
        SHPRT_STREAM(to + i + part, lanes);
      }
  }
#endif
  __builtin_memcpy(to + i, from + i, (count - i) * sizeof(float));
}

void rotateManyBandKernel(int size, const float* matrix, const float* from, float* to, std::size_t setCount,
                          std::size_t stride, bool pastCaches, float* scratch) {
  const auto rows = static_cast<std::size_t>(size);
  float* const ragged = scratch + rows * kManyBlock;
  // The first block ends where a line of row 0 does, and with it, for whole-line strides, every row's.
  std::size_t count = kManyBlock - reinterpret_cast<unsigned long long>(to) / 4 % 16;
  for (std::size_t first = 0; first < setCount; first += count, count = kManyBlock) {
    if (count > setCount - first) count = setCount - first;
    std::size_t k = 0;
    for (; k + kFloats <= count; k += kFloats) {
      const float* const block = from + first + k;
      multiplyVector(size, matrix, block, stride, scratch + k);
    }
    if (k < count) {
      // The last sets are filled up to a vector with zeros.
      for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t lane = 0; lane < kFloats; ++lane)
          ragged[row * kManyBlock + lane] = k + lane < count ? from[row * stride + first + k + lane] : 0;
      multiplyVector(size, matrix, ragged, kManyBlock, scratch + k);
    }
    for (std::size_t row = 0; row < rows; ++row) {
      float* const target = to + row * stride + first;
      for (std::size_t i = first + kPrefetchAhead; i < first + kPrefetchAhead + count && i < setCount;
           i += 16)
        __builtin_prefetch(from + row * stride + i);
      if (pastCaches) {
        streamOut(scratch + row * kManyBlock, count, target);
      } else {
        __builtin_memcpy(target, scratch + row * kManyBlock, count * sizeof(float));
      }
    }
  }
#if defined(SHPRT_STREAM)
  if (pastCaches) __builtin_ia32_sfence();  // such stores are ordered with no others
#endif
}

}  // namespace

}  // namespace shprt
