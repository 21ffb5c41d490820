// Many coefficient sets by one dense matrix, vectorised over sets. Compiled like rotation_kernel.h. Where
// whole lines of results come out, they leave straight past the caches: then a result costs memory one write,
// as in a copy. What is ragged is made in the first cache and leaves it row by row.

#include "shprt/sh/rotation_variants.h"

namespace shprt {
namespace {

using Floats = float __attribute__((vector_size(SHPRT_LANE_BYTES)));
constexpr std::size_t kFloats = SHPRT_LANE_BYTES / 4;
// Sets between what is worked on and what is fetched: rows are far apart, which hides them from prefetchers.
constexpr std::size_t kPrefetchAhead = 256;
// Rows that are written past the caches side by side. With more than processors have buffers for, lines leave
// half filled, at twice the time (measured: 7 rows cost what a copy does, 9 more than twice that).
constexpr int kStreamedRows = 7;

#if defined(SHPRT_STREAM)
constexpr bool kCanStream = true;
inline void stream(const Floats& lanes, float* to) {
  SHPRT_STREAM(to, lanes);
}
#else
constexpr bool kCanStream = false;
inline void stream(const Floats& lanes, float* to) {
  __builtin_memcpy(to, &lanes, sizeof lanes);
}
#endif

// kRows rows of the product for one vector of sets; matrix points at the first of them.
template <int kRows, bool kStreamed>
inline void multiplyRows(int size, const float* matrix, const float* from, std::size_t stride, float* to,
                         std::size_t toStride) {
  Floats sums[kRows];
  for (int row = 0; row < kRows; ++row) sums[row] = Floats{};
  for (int k = 0; k < size; ++k) {
    Floats entry;
    __builtin_memcpy(&entry, from + static_cast<std::size_t>(k) * stride, sizeof entry);
    for (int row = 0; row < kRows; ++row) sums[row] += entry * matrix[k * size + row];
  }
  for (int row = 0; row < kRows; ++row) {
    float* const target = to + static_cast<std::size_t>(row) * toStride;
    if constexpr (kStreamed) {
      stream(sums[row], target);
    } else {
      __builtin_memcpy(target, &sums[row], sizeof sums[row]);
    }
  }
}

// The same for a number of rows that is known at run time, at most kRows.
template <int kRows, bool kStreamed>
inline void multiplyUpTo(int size, int rows, const float* matrix, const float* from, std::size_t stride,
                         float* to, std::size_t toStride) {
  if constexpr (kRows > 0) {
    if (rows == kRows) {
      multiplyRows<kRows, kStreamed>(size, matrix, from, stride, to, toStride);
    } else {
      multiplyUpTo<kRows - 1, kStreamed>(size, rows, matrix, from, stride, to, toStride);
    }
  }
}

// All rows for one vector of sets, into the block in the first cache.
inline void multiplyVector(int size, const float* matrix, const float* from, std::size_t stride, float* to) {
  constexpr int kTile = SHPRT_LANE_BYTES == 64 ? 9 : 5;
  for (int row = 0; row < size; row += kTile)
    multiplyUpTo<kTile, false>(size, row + kTile <= size ? kTile : size - row, matrix + row, from, stride,
                               to + static_cast<std::size_t>(row) * kManyBlock, kManyBlock);
}

// kRows rows for a block of whole vectors whose targets are whole lines. The first rows of a matrix also
// fetch what comes after the block.
template <int kRows>
inline void streamRows(int size, bool fetch, const float* matrix, const float* from, std::size_t stride,
                       std::size_t count, float* to) {
  for (std::size_t k = 0; k < count; k += kFloats) {
    if (fetch) {
      for (int row = 0; row < size; ++row)
        __builtin_prefetch(from + static_cast<std::size_t>(row) * stride + k + kPrefetchAhead);
    }
    multiplyRows<kRows, true>(size, matrix, from + k, stride, to + k, stride);
  }
}

template <int kRows>
inline void streamUpTo(int size, int rows, bool fetch, const float* matrix, const float* from,
                       std::size_t stride, std::size_t count, float* to) {
  if constexpr (kRows > 0) {
    if (rows == kRows) {
      streamRows<kRows>(size, fetch, matrix, from, stride, count, to);
    } else {
      streamUpTo<kRows - 1>(size, rows, fetch, matrix, from, stride, count, to);
    }
  }
}

inline void multiplyStreamed(int size, const float* matrix, const float* from, std::size_t stride,
                             std::size_t count, float* to) {
  const int tiles = (size + kStreamedRows - 1) / kStreamedRows, tile = (size + tiles - 1) / tiles;
  for (int row = 0; row < size; row += tile)
    streamUpTo<kStreamedRows>(size, row + tile <= size ? tile : size - row, row == 0, matrix + row, from,
                              stride, count, to + static_cast<std::size_t>(row) * stride);
}

inline void streamOut(const float* from, std::size_t count, float* to) {
  std::size_t i = 0;
  if constexpr (kCanStream) {
    const auto misplaced = reinterpret_cast<unsigned long long>(to) % 64 / 4;
    if (count >= 32) {
      for (const std::size_t head = (16 - misplaced) % 16; i < head; ++i) to[i] = from[i];
      for (; i + 16 <= count; i += 16)
        for (std::size_t part = 0; part < 16; part += kFloats) {
          Floats lanes;
          __builtin_memcpy(&lanes, from + i + part, sizeof lanes);
          stream(lanes, to + i + part);
        }
    }
  }
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
    const bool wholeLines =
        stride % 16 == 0 && count % 16 == 0 && reinterpret_cast<unsigned long long>(to + first) % 64 == 0;
    if (kCanStream && pastCaches && wholeLines) {
      multiplyStreamed(size, matrix, from + first, stride, count, to + first);
      continue;
    }
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
