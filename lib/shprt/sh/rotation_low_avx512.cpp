// The rotation of the lowest bands for processors with AVX-512: to degree 7 a band's cosine entries fill one
// register, four of the even group and then four of the odd group (rotation_swap.h), and its sine entries
// another. A turn about z is then four instructions, and an exchange of y and z one product for each column.

#include <utility>

#include "shprt/sh/rotation_variants.h"

#if defined(__x86_64__)
#include <immintrin.h>
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx512f,avx2,fma"))), apply_to = function)
#else
#pragma GCC target("avx512f,avx2,fma")
#endif

#include "shprt/sh/rotation_kernel_turns.h"

namespace shprt {
namespace {

struct alignas(64) Lanes {
  long long indices[8];
};

// Where m = 0..l of band kL sits in a register, and which entry of the band a lane holds.
template <int kL>
struct BandLanes {
  static constexpr int laneOf(int m) { return ((kL + m) % 2) * 4 + m / 2; }
  static constexpr Lanes split(int sign) {
    Lanes lanes{};
    for (int m = 0; m <= kL; ++m) lanes.indices[laneOf(m)] = kL + sign * m;
    return lanes;
  }
  // Entries from `first` on: lanes of the cosines, then those of the sines.
  static constexpr Lanes join(int first) {
    Lanes lanes{};
    for (int i = 0; i < 8 && first + i <= 2 * kL; ++i) {
      const int m = first + i - kL;
      lanes.indices[i] = m < 0 ? 8 + laneOf(-m) : laneOf(m);
    }
    return lanes;
  }
  static constexpr Lanes kCosines = split(1), kSines = split(-1), kLow = join(0), kHigh = join(8);
  static constexpr int kEntries = 2 * kL + 1;
  static constexpr __mmask8 kLowMask = kEntries >= 8 ? 0xff : (1 << kEntries) - 1;
  static constexpr __mmask8 kHighMask = kEntries > 8 ? (1 << (kEntries - 8)) - 1 : 0;
};

// Lane k of the cosines four times, then that of the sines.
constexpr Lanes spread(int k) {
  return {{k, k, k, k, 8 + k, 8 + k, 8 + k, 8 + k}};
}
constexpr Lanes kSpread[8] = {spread(0), spread(1), spread(2), spread(3),
                              spread(4), spread(5), spread(6), spread(7)};

inline __m512i indicesOf(const Lanes& lanes) {
  return _mm512_load_si512(lanes.indices);
}

struct Entries {
  __m512d cosines, sines;
};

// Entries times a unit complex number in each lane.
inline Entries turned(const Entries& a, const Entries& turn) {
  return {_mm512_fmsub_pd(a.cosines, turn.cosines, _mm512_mul_pd(a.sines, turn.sines)),
          _mm512_fmadd_pd(a.cosines, turn.sines, _mm512_mul_pd(a.sines, turn.cosines))};
}

inline __m512d term(const Entries& a, int lane) {
  return _mm512_permutex2var_pd(a.cosines, indicesOf(kSpread[lane]), a.sines);
}

// Columns of the exchange: first those that make cosines, then those that make sines.
template <int kL>
inline Entries exchanged(const Entries& a, const double* columns) {
  constexpr int kEven = kL / 2 + 1, kOdd = (kL + 1) / 2;
  Entries to = {_mm512_mul_pd(term(a, 0), _mm512_load_pd(columns)),
                _mm512_mul_pd(term(a, 4), _mm512_load_pd(columns + 8 * kEven))};
#pragma GCC unroll 4
  for (int k = 1; k < kEven; ++k)
    to.cosines = _mm512_fmadd_pd(term(a, k), _mm512_load_pd(columns + 8 * k), to.cosines);
#pragma GCC unroll 4
  for (int k = 1; k < kOdd; ++k)
    to.sines = _mm512_fmadd_pd(term(a, 4 + k), _mm512_load_pd(columns + 8 * (kEven + k)), to.sines);
  return to;
}

// The three turns: lanes of multiples 0, 2, 4, 6, 1, 3, 5, 7 for even bands, halves exchanged for odd ones.
struct Turns {
  Entries even[3], odd[3];
};

template <int kL>
inline void loadBand(const double* set, Entries& entries) {
  using Layout = BandLanes<kL>;
  const double* const band = set + kL * kL;
  const __m512d low = _mm512_maskz_loadu_pd(Layout::kLowMask, band);
  const __m512d high = Layout::kHighMask ? _mm512_maskz_loadu_pd(Layout::kHighMask, band + 8) : low;
  entries = {_mm512_permutex2var_pd(low, indicesOf(Layout::kCosines), high),
             _mm512_permutex2var_pd(low, indicesOf(Layout::kSines), high)};
}

template <int kL>
inline void rotateBand(const UnrolledSwaps& swaps, const Turns& turns, Entries& entries) {
  const Entries* turn = kL % 2 ? turns.odd : turns.even;
  entries = turned(entries, turn[0]);
  entries = turned(exchanged<kL>(entries, swaps.lanes[kL]), turn[1]);
  entries = turned(exchanged<kL>(entries, swaps.lanes[kL]), turn[2]);
}

template <int kL>
inline void storeBand(const Entries& entries, double* set) {
  using Layout = BandLanes<kL>;
  double* const band = set + kL * kL;
  _mm512_mask_storeu_pd(band, Layout::kLowMask,
                        _mm512_permutex2var_pd(entries.cosines, indicesOf(Layout::kLow), entries.sines));
  if constexpr (Layout::kHighMask != 0) {
    _mm512_mask_storeu_pd(band + 8, Layout::kHighMask,
                          _mm512_permutex2var_pd(entries.cosines, indicesOf(Layout::kHigh), entries.sines));
  }
}

// Bands 2, 3, ... All are loaded before any is stored: a masked store would hold up the loads beside it.
template <int... kStep>
inline void rotateBands(const UnrolledSwaps& swaps, const Turns& turns, double* set,
                        std::integer_sequence<int, kStep...>) {
  Entries entries[sizeof...(kStep)];
  (loadBand<2 + kStep>(set, entries[kStep]), ...);
  (rotateBand<2 + kStep>(swaps, turns, entries[kStep]), ...);
  (storeBand<2 + kStep>(entries[kStep], set), ...);
}

inline Entries squared(const Entries& a) {
  return {_mm512_mul_pd(_mm512_sub_pd(a.cosines, a.sines), _mm512_add_pd(a.cosines, a.sines)),
          _mm512_mul_pd(_mm512_add_pd(a.cosines, a.cosines), a.sines)};
}

// A power in the chosen lanes, 1 in the others.
inline Entries powerIn(__mmask8 lanes, const Entries& power) {
  return {_mm512_mask_mov_pd(_mm512_set1_pd(1), lanes, power.cosines),
          _mm512_maskz_mov_pd(lanes, power.sines)};
}

// e^(i m a) in every lane for m up to kDegree, from the first, second and fourth power by the bits of m.
template <int kDegree>
inline Entries powersOf(const CosineSine& turn) {
  const Entries first = {_mm512_set1_pd(turn.c), _mm512_set1_pd(turn.s)}, second = squared(first);
  const Entries low = turned(powerIn(0xf0, first), powerIn(0xaa, second));
  return kDegree < 4 ? low : turned(low, powerIn(0xcc, squared(second)));
}

inline Entries withHalvesExchanged(const Entries& a) {
  const __m512i halves = _mm512_set_epi64(3, 2, 1, 0, 7, 6, 5, 4);
  return {_mm512_permutex2var_pd(a.cosines, halves, a.cosines),
          _mm512_permutex2var_pd(a.sines, halves, a.sines)};
}

template <int kDegree>
inline void rotateFromBandTwo(const UnrolledSwaps& swaps, const Mat3& matrix, double* set) {
  const ZTurns angles = zTurns(matrix);
  Turns turns;
#pragma GCC unroll 3
  for (int turn = 0; turn < 3; ++turn) {
    turns.even[turn] = powersOf<kDegree>(angles.turns[turn]);
    turns.odd[turn] = withHalvesExchanged(turns.even[turn]);
  }
  rotateBands(swaps, turns, set, std::make_integer_sequence<int, kDegree - 1>{});
}

}  // namespace

void rotateLowAvx512(int degree, const UnrolledSwaps& swaps, const Mat3& matrix, double* set) {
  if (degree >= 1) rotateFirstBand(matrix, set);
  switch (degree) {
    case 2:
      return rotateSecondBand(matrix, set);  // for it alone the turns are not worth their making
    case 3:
      return rotateFromBandTwo<3>(swaps, matrix, set);
    case 4:
      return rotateFromBandTwo<4>(swaps, matrix, set);
    case 5:
      return rotateFromBandTwo<5>(swaps, matrix, set);
    case 6:
      return rotateFromBandTwo<6>(swaps, matrix, set);
    case 7:
      return rotateFromBandTwo<7>(swaps, matrix, set);
  }
}

}  // namespace shprt

#if defined(__clang__)
#pragma clang attribute pop
#endif
#endif
