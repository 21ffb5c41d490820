// Based on: the Wigner matrices at a quarter turn about y, d_mn = d^l_mn(pi/2). Row l is a binomial, d_ln =
// (-1)^(l-n) 2^-l sqrt(C(2l, l+n)); the rows below follow from the ladder relation c(m) d_{m+1,n} + c(m-1)
// d_{m-1,n} = 2n d_mn, c(m)^2 = (l-m)(l+m+1), which says that columns are eigenvectors of J_x. Taken from m =
// l down to m = n it only ever grows or oscillates, so it is stable; the rest is symmetry, d_nm = (-1)^(m-n)
// d_mn. Each band stands by itself, so no error is handed from band to band. Pinchon and Hoggan 2007 have the
// idea of the one fixed matrix.

#include "shprt/sh/rotation_swap.h"

#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <memory>
#include <mutex>
#include <numbers>
#include <utility>

#include "shprt/sh/rotation.h"

namespace shprt {
namespace {

constexpr int padded(int count) {
  return (count + kSwapPadding - 1) / kSwapPadding * kSwapPadding;
}

// (-1)^(m/2): what a quarter turn about z makes of y_m.
constexpr double quarterSign(int m) {
  return m / 2 % 2 ? -1 : 1;
}

// Writes row m of d, up to the diagonal, to all the places of the exchange that it determines.
class SwapWriter {
 public:
  SwapWriter(SwapBand& band, double* blocks)
      : band_(band),
        evenCosines_(blocks),
        evenSines_(evenCosines_ + band.even * band.evenStride),
        oddCosines_(evenSines_ + band.odd * band.evenStride),
        oddSines_(oddCosines_ + band.even * band.oddStride) {
    band.evenCosines = evenCosines_;
    band.evenSines = evenSines_;
    band.oddCosines = oddCosines_;
    band.oddSines = oddSines_;
  }

  void writeRow(int m, const double* row) const {
    const bool evenRow = (band_.l + m) % 2 == 0;
    const int i = m / 2, evenStride = band_.evenStride, oddStride = band_.oddStride;
    const double rowSign = 2 * quarterSign(m), mixedSign = band_.l % 2 ? -rowSign : rowSign;
    for (int n = m % 2; n <= m; n += 2) {
      const int k = n / 2;
      const double entry = rowSign * quarterSign(n) * row[n];
      if (evenRow) {
        const double scaled = n > 0 ? entry : entry * (m > 0 ? kHalfRoot : 0.5);
        evenCosines_[k * evenStride + i] = evenCosines_[i * evenStride + k] = scaled;
      } else if (n > 0) {
        oddSines_[k * oddStride + i] = oddSines_[i * oddStride + k] = -entry;
      }
    }
    for (int n = 1 - m % 2; n < m; n += 2) {
      const int k = n / 2;
      const double entry = mixedSign * quarterSign(n) * row[n];
      if (evenRow) {
        evenSines_[k * evenStride + i] = oddCosines_[i * oddStride + k] = n > 0 ? entry : entry * kHalfRoot;
      } else if (n > 0) {
        evenSines_[i * evenStride + k] = oddCosines_[k * oddStride + i] = -entry;
      }
    }
  }

 private:
  static constexpr double kHalfRoot = std::numbers::sqrt2 / 2;

  const SwapBand& band_;
  double *evenCosines_, *evenSines_, *oddCosines_, *oddSines_;
};

}  // namespace

void buildSwapBand(int l, SwapBand& band) {
  assert(l >= 0 && l <= kMaximumRotationDegree);
  band.l = l;
  band.even = l / 2 + 1;
  band.odd = (l + 1) / 2;
  band.evenStride = padded(band.even);
  band.oddStride = padded(band.odd);
  band.storage.assign(
      static_cast<std::size_t>((band.even + band.odd) * (band.evenStride + band.oddStride) / kSwapPadding),
      {});
  const SwapWriter writer(band, band.storage.empty() ? nullptr : band.storage.front().entries);

  std::vector<double> above(static_cast<std::size_t>(l) + 1), row(above.size());
  double central = 1;  // C(2l, l) / 4^l
  for (int k = 1; k <= l; ++k) central *= 1 - 0.5 / k;
  double seed = l % 2 ? -std::sqrt(central) : std::sqrt(central);
  for (int n = 0; n <= l; ++n) {
    row[static_cast<std::size_t>(n)] = seed;
    seed *= -std::sqrt(static_cast<double>(l - n) / (l + n + 1));
  }
  writer.writeRow(l, row.data());
  for (int m = l; m > 0; --m) {
    const double stepDown = 1 / std::sqrt(static_cast<double>(l + m) * (l - m + 1));
    const double twice = 2 * stepDown, back = std::sqrt(static_cast<double>(l - m) * (l + m + 1)) * stepDown;
    double* next = above.data();
    const double* current = row.data();
    for (int n = 0; n < m; ++n) next[n] = twice * n * current[n] - back * next[n];
    std::swap(above, row);
    writer.writeRow(m - 1, row.data());
  }
}

const SwapBand& cachedSwapBand(int l) {
  assert(l >= 0 && l <= kMaximumCachedSwapBand);
  static std::array<std::atomic<const SwapBand*>, kMaximumCachedSwapBand + 1> published{};
  static std::array<std::unique_ptr<SwapBand>, kMaximumCachedSwapBand + 1> owned;
  static std::mutex building;
  const auto slot = static_cast<std::size_t>(l);
  if (const SwapBand* band = published[slot].load(std::memory_order_acquire)) return *band;
  const std::lock_guard lock(building);
  if (!owned[slot]) {
    auto band = std::make_unique<SwapBand>();
    buildSwapBand(l, *band);
    owned[slot] = std::move(band);
    published[slot].store(owned[slot].get(), std::memory_order_release);
  }
  return *owned[slot];
}

}  // namespace shprt
