// The rotation of one coefficient set, compiled once for each instruction set by the files that include it
// with SHPRT_LANE_BYTES, the bytes of a vector register, and SHPRT_ROTATION_VARIANT, a name. It uses the
// compiler's vector types only and no library function, so that no code for a newer processor can leak out.
//
// A band goes through turn, exchange, turn, exchange, turn. Within a band the even group (rotation_swap.h)
// and the odd group do not meet in a turn about z, and the exchange leads each group's new cosines and sines
// from one old vector each: two dense products side by side.

#include "shprt/sh/rotation_variants.h"

namespace shprt {
namespace {

using Doubles = double __attribute__((vector_size(SHPRT_LANE_BYTES)));
constexpr int kDoubles = SHPRT_LANE_BYTES / 8;

inline void loadDoubles(const double* from, Doubles& lanes) {
  __builtin_memcpy(&lanes, from, sizeof lanes);
}

inline void storeDoubles(const Doubles& lanes, double* to) {
  __builtin_memcpy(to, &lanes, sizeof lanes);
}

// Pairs of cosine and sine entries of one group.
struct Group {
  double *cosines, *sines;
};

// One group after an exchange: cosines from `fromCosines` by block a, sines from `fromSines` by block b.
struct GroupExchange {
  const double *a, *b;
  const double *fromCosines, *fromSines;
  int aColumns, bColumns;
  int stride;
};

// kVectors vectors of rows, from `row`, of one group: exchanged and then turned about z.
template <int kVectors>
inline void exchangeAndTurnRows(const GroupExchange& x, int row, const double* turnCosine,
                                const double* turnSine, const Group& to) {
  Doubles cosines[kVectors], sines[kVectors];
  for (int v = 0; v < kVectors; ++v) cosines[v] = sines[v] = Doubles{};
  const double *a = x.a + row, *b = x.b + row;
  const int both = x.aColumns < x.bColumns ? x.aColumns : x.bColumns;
  int n = 0;
  for (; n < both; ++n, a += x.stride, b += x.stride)
    for (int v = 0; v < kVectors; ++v) {
      Doubles columnA, columnB;
      loadDoubles(a + v * kDoubles, columnA);
      loadDoubles(b + v * kDoubles, columnB);
      cosines[v] += columnA * x.fromCosines[n];
      sines[v] += columnB * x.fromSines[n];
    }
  // The column counts differ by one at most.
  if (n < x.aColumns) {
    for (int v = 0; v < kVectors; ++v) {
      Doubles column;
      loadDoubles(a + v * kDoubles, column);
      cosines[v] += column * x.fromCosines[n];
    }
  } else if (n < x.bColumns) {
    for (int v = 0; v < kVectors; ++v) {
      Doubles column;
      loadDoubles(b + v * kDoubles, column);
      sines[v] += column * x.fromSines[n];
    }
  }
  for (int v = 0; v < kVectors; ++v) {
    const int at = row + v * kDoubles;
    Doubles c, s;
    loadDoubles(turnCosine + at, c);
    loadDoubles(turnSine + at, s);
    storeDoubles(cosines[v] * c - sines[v] * s, to.cosines + at);
    storeDoubles(cosines[v] * s + sines[v] * c, to.sines + at);
  }
}

inline void exchangeAndTurn(const GroupExchange& x, int count, const double* turnCosine,
                            const double* turnSine, const Group& to) {
  int row = 0;
  for (; row + 2 * kDoubles < count; row += 3 * kDoubles)
    exchangeAndTurnRows<3>(x, row, turnCosine, turnSine, to);
  if (row + kDoubles < count) {
    exchangeAndTurnRows<2>(x, row, turnCosine, turnSine, to);
  } else if (row < count) {
    exchangeAndTurnRows<1>(x, row, turnCosine, turnSine, to);
  }
}

// Splits a band into groups, turning it about z on the way.
inline void splitAndTurn(const double* band, int first, int count, const double* turnCosine,
                         const double* turnSine, const Group& to) {
  for (int i = 0; i < count; ++i) {
    const int m = first + 2 * i;
    const double plus = band[m], minus = band[-m];
    to.cosines[i] = turnCosine[i] * plus - turnSine[i] * minus;
    to.sines[i] = turnSine[i] * plus + turnCosine[i] * minus;
  }
}

inline void join(const Group& from, int first, int count, double* band) {
  for (int i = 0; i < count; ++i) {
    band[-first - 2 * i] = from.sines[i];
    band[first + 2 * i] = from.cosines[i];
  }
}

void rotateBandKernel(const SwapBand& swap, const TurnTables& tables, double* scratch, double* band) {
  const int parity = swap.l % 2, stride = swap.evenStride;
  Group even = {scratch, scratch + stride}, odd = {scratch + 2 * stride, scratch + 3 * stride};
  Group nextEven = {scratch + 4 * stride, scratch + 5 * stride};
  Group nextOdd = {scratch + 6 * stride, scratch + 7 * stride};
  const auto& first = tables.turns[0];
  splitAndTurn(band, parity, swap.even, first.cosine[parity], first.sine[parity], even);
  splitAndTurn(band, 1 - parity, swap.odd, first.cosine[1 - parity], first.sine[1 - parity], odd);
  if (parity == 0)
    even.sines[0] = 0;  // y_l0 has no sine
  else
    odd.sines[0] = 0;
  for (int step = 1; step < 3; ++step) {
    const auto& turn = tables.turns[step];
    exchangeAndTurn(
        {swap.evenCosines, swap.evenSines, even.cosines, odd.cosines, swap.even, swap.odd, swap.evenStride},
        swap.even, turn.cosine[parity], turn.sine[parity], nextEven);
    exchangeAndTurn(
        {swap.oddCosines, swap.oddSines, even.sines, odd.sines, swap.even, swap.odd, swap.oddStride},
        swap.odd, turn.cosine[1 - parity], turn.sine[1 - parity], nextOdd);
    const Group turnedEven = nextEven, turnedOdd = nextOdd;
    nextEven = even, nextOdd = odd;
    even = turnedEven, odd = turnedOdd;
  }
  // Sines first: at m = 0 the cosine must remain.
  join(even, parity, swap.even, band);
  join(odd, 1 - parity, swap.odd, band);
}

}  // namespace
}  // namespace shprt
