// The exchange of y and z as a matrix on each band of real harmonics: the one fixed matrix that rotations
// need, since a turn about y is a turn about z between two exchanges. It is symmetric, its own inverse, and
// keeps or exchanges the parities in y and z, so that it falls into four dense blocks with a quarter of a
// band's entries between them.
//
// Groups: in band l an index m = 0..l is "even" when l + m is, and "odd" otherwise; each group is stored in
// rising m, so m sits at m / 2. Of either there are the cosine entries (y_lm, even in y) and the sine entries
// (y_l,-m). y_l0 has no sine; a zero stands for it.
#pragma once

#include <vector>

namespace shprt {

// Rows are padded with zeros to whole cache lines of doubles.
inline constexpr int kSwapPadding = 8;

struct SwapBand {
  struct alignas(64) Line {
    double entries[kSwapPadding];
  };

  int l = 0;
  int even = 0, odd = 0;              // entries in a group
  int evenStride = 0, oddStride = 0;  // the same, padded
  // Blocks in column-major order: even cosines to themselves, odd cosines to even sines, even sines to odd
  // cosines (the transpose), odd sines to themselves.
  const double* evenCosines = nullptr;
  const double* evenSines = nullptr;
  const double* oddCosines = nullptr;
  const double* oddSines = nullptr;
  std::vector<Line> storage;
};

// Fills band with the exchange of y and z in band l, in O(l^2); its storage is used again. For l in [0,
// kMaximumRotationDegree]. Entries are right to 1e-15 at least to l = 1000.
void buildSwapBand(int l, SwapBand& band);

inline constexpr int kMaximumCachedSwapBand = 128;

// The same for l <= kMaximumCachedSwapBand, built at its first use and kept; thread-safe.
const SwapBand& cachedSwapBand(int l);

}  // namespace shprt
