// The one float evaluation of spherical harmonics: a few vectors of directions at a time, for any sink of
// values. Compiled once for each instruction set by the files that include it, which define SHPRT_LANES, the
// floats of a vector, first. It uses the compiler's vector types only and no library function, so that no
// code for a newer processor can leak out. Vectors travel by reference: passed by value they would have
// another ABI in each variant. The recurrence is that of recurrence.h. Scalar twin and reference: evaluateSh.
//
// A sink has  tell(i, a, b),  called once for every coefficient i: a and b are arrays of kVectors vectors,
// and the weighted values of the coefficient are a * b.

#include <cstddef>

#include "shprt/sh/evaluation_tables.h"

#define SHPRT_INLINE __attribute__((always_inline)) inline
// Loops over the vectors must be gone before the compiler decides what lives in registers; clang sees to it
// itself.
#if defined(__clang__)
#define SHPRT_UNROLL
#else
#define SHPRT_UNROLL _Pragma("GCC unroll 8")
#endif

namespace shprt {
namespace {

constexpr std::size_t kLanes = SHPRT_LANES;
using Lanes = float __attribute__((vector_size(4 * SHPRT_LANES)));
using LaneBits = int __attribute__((vector_size(4 * SHPRT_LANES)));
// At any address.
struct __attribute__((packed, may_alias)) LooseLanes {
  Lanes lanes;
};

SHPRT_INLINE void loadLanes(const float* from, Lanes& lanes) {
  lanes = reinterpret_cast<const LooseLanes*>(from)->lanes;
}
SHPRT_INLINE void storeLanes(const Lanes& lanes, float* to) {
  reinterpret_cast<LooseLanes*>(to)->lanes = lanes;
}

// a to a multiple of 2^-23 floor, or nearer: of the order of 2^-61 where a may be 1. Products of two such
// numbers are no subnormal numbers, which would arise beside the poles and at which processors are slow.
constexpr float kFloor = 0x1p-38f;
SHPRT_INLINE Lanes withoutDust(const Lanes& a, const Lanes& floor) {
  return (a + floor) - floor;
}

constexpr int kAnyDegree = -1;

// What the recurrences need of kVectors vectors of directions, and the weights that multiply every value.
template <int kVectors>
struct Directions {
  Lanes x[kVectors], y[kVectors];
  Lanes t[kVectors], height[kVectors];  // 1 - |z| and |z|
  LaneBits south[kVectors];             // the sign bit of z
  Lanes weight[kVectors];
  Lanes floor[kVectors];  // kFloor times the weight
};

template <int kVectors>
SHPRT_INLINE void prepare(const float* x, const float* y, const float* z, Directions<kVectors>& u) {
  const Lanes floor = Lanes{} + kFloor;
  SHPRT_UNROLL for (int v = 0; v < kVectors; ++v) {
    Lanes height;
    loadLanes(x + v * kLanes, u.x[v]);
    loadLanes(y + v * kLanes, u.y[v]);
    loadLanes(z + v * kLanes, height);
    u.x[v] = withoutDust(u.x[v], floor);
    u.y[v] = withoutDust(u.y[v], floor);
    u.south[v] = (LaneBits)height & static_cast<int>(0x80000000u);
    height = (Lanes)((LaneBits)height ^ u.south[v]);
    // |u|^2 - 1, known precisely near a pole, where it is twice the rounding of z: all terms are small and
    // exact to rounding. So t comes from x and y there, and from z beside the equator.
    const Lanes drop = 1.0f - height;
    const Lanes excess = u.x[v] * u.x[v] + u.y[v] * u.y[v] - drop * (1.0f + height);
    u.t[v] = drop + 0.5f * height * excess;
    u.height[v] = 1.0f - u.t[v];
  }
}

// Where the recurrences of one order m >= 0 stand. The power is the weight times (x + iy)^m.
template <int kVectors>
struct Order {
  Lanes re[kVectors], im[kVectors];
  Lanes g[kVectors], d[kVectors];
};

template <int kVectors>
SHPRT_INLINE void startOrder(int m, const Directions<kVectors>& u, Order<kVectors>& o) {
  SHPRT_UNROLL for (int v = 0; v < kVectors; ++v) {
    if (m == 0) {
      o.re[v] = u.weight[v];
    } else if (m == 1) {
      o.im[v] = o.re[v] * u.y[v];
      o.re[v] = o.re[v] * u.x[v];
    } else {
      const Lanes re = withoutDust(o.re[v] * u.x[v] - o.im[v] * u.y[v], u.floor[v]);
      o.im[v] = withoutDust(o.re[v] * u.y[v] + o.im[v] * u.x[v], u.floor[v]);
      o.re[v] = re;
    }
  }
}

template <int kVectors, typename Sink>
SHPRT_INLINE void tellBand(int l, int m, const Lanes (&polynomial)[kVectors], const Order<kVectors>& o,
                           Sink& sink) {
  sink.tell(l * (l + 1) + m, polynomial, o.re);
  if (m > 0) sink.tell(l * (l + 1) - m, polynomial, o.im);
}

// Band m, in which G = 1.
template <int kVectors, typename Sink>
SHPRT_INLINE void firstBand(int m, float norm, const Order<kVectors>& o, Sink& sink) {
  Lanes polynomial[kVectors];
  SHPRT_UNROLL for (int v = 0; v < kVectors; ++v) polynomial[v] = Lanes{} + norm;
  tellBand(m, m, polynomial, o, sink);
}

// Band m + 1, in which D = -t.
template <int kVectors, typename Sink>
SHPRT_INLINE void secondBand(int m, float norm, const Directions<kVectors>& u, Order<kVectors>& o,
                             Sink& sink) {
  Lanes polynomial[kVectors];
  SHPRT_UNROLL for (int v = 0; v < kVectors; ++v) {
    o.d[v] = -u.t[v];
    o.g[v] = u.height[v];
    polynomial[v] = norm * o.g[v];
    polynomial[v] = (Lanes)((LaneBits)polynomial[v] ^ u.south[v]);
  }
  tellBand(m + 1, m, polynomial, o, sink);
}

// Band l >= m + 2. kOdd says that y_lm is odd in z.
template <bool kOdd, int kVectors, typename Sink>
SHPRT_INLINE void nextBand(int l, int m, const FloatStep& step, const Directions<kVectors>& u,
                           Order<kVectors>& o, Sink& sink) {
  Lanes polynomial[kVectors];
  SHPRT_UNROLL for (int v = 0; v < kVectors; ++v) {
    // The factor of t G, 1 + alpha, is formed apart from G: that shortens the chain from one band to the
    // next.
    o.d[v] = step.alpha * o.d[v] - (step.alpha * u.t[v] + u.t[v]) * o.g[v];
    o.g[v] += o.d[v];
    polynomial[v] = step.norm * o.g[v];
    if constexpr (kOdd) polynomial[v] = (Lanes)((LaneBits)polynomial[v] ^ u.south[v]);
  }
  tellBand(l, m, polynomial, o, sink);
}

// Unrolled: the bands kL to kDegree of order kM, and the orders kM to kDegree.
template <int kDegree, int kM, int kL, int kVectors, typename Sink>
SHPRT_INLINE void unrolledBands(const FloatStep* steps, const Directions<kVectors>& u, Order<kVectors>& o,
                                Sink& sink) {
  if constexpr (kL <= kDegree) {
    nextBand<(kL - kM) % 2 != 0>(kL, kM, steps[kL - kM], u, o, sink);
    unrolledBands<kDegree, kM, kL + 1>(steps, u, o, sink);
  }
}

template <int kDegree, int kM, int kVectors, typename Sink>
SHPRT_INLINE void unrolledOrders(const EvaluationTables& tables, const Directions<kVectors>& u,
                                 Order<kVectors>& o, Sink& sink) {
  if constexpr (kM <= kDegree) {
    const FloatStep* steps = tables.order(kM);
    startOrder(kM, u, o);
    firstBand(kM, steps[0].norm, o, sink);
    if constexpr (kM < kDegree) secondBand(kM, steps[1].norm, u, o, sink);
    unrolledBands<kDegree, kM, kM + 2>(steps, u, o, sink);
    unrolledOrders<kDegree, kM + 1>(tables, u, o, sink);
  }
}

// Rolled: the bands of order m, for a degree known at run time only.
template <int kVectors, typename Sink>
SHPRT_INLINE void rolledBands(const EvaluationTables& tables, int degree, int m,
                              const Directions<kVectors>& u, Order<kVectors>& o, Sink& sink) {
  const FloatStep* step = tables.order(m);
  startOrder(m, u, o);
  firstBand(m, step->norm, o, sink);
  if (m == degree) return;
  secondBand(m, (++step)->norm, u, o, sink);
  int l = m + 2;
  for (; l < degree; l += 2) {
    nextBand<false>(l, m, *++step, u, o, sink);
    nextBand<true>(l + 1, m, *++step, u, o, sink);
  }
  if (l == degree) nextBand<false>(l, m, *++step, u, o, sink);
}

// Every coefficient of kVectors vectors of directions; kDegree is `degree`, or kAnyDegree.
template <int kDegree, int kVectors, typename Sink>
SHPRT_INLINE void evaluateVectors(const EvaluationTables& tables, int degree, const Directions<kVectors>& u,
                                  Sink& sink) {
  Order<kVectors> o;
  if constexpr (kDegree != kAnyDegree) {
    unrolledOrders<kDegree, 0>(tables, u, o, sink);
  } else {
    rolledBands(tables, degree, 0, u, o, sink);
    if (degree == 0) return;
    rolledBands(tables, degree, 1, u, o, sink);
    for (int m = 2; m <= degree; ++m) rolledBands(tables, degree, m, u, o, sink);
  }
}

// function.template operator()<kDegree>() with the degree as a constant up to 4, beyond with kAnyDegree.
template <typename Function>
SHPRT_INLINE void withDegree(int degree, const Function& function) {
  switch (degree) {
    case 0:
      return function.template operator()<0>();
    case 1:
      return function.template operator()<1>();
    case 2:
      return function.template operator()<2>();
    case 3:
      return function.template operator()<3>();
    case 4:
      return function.template operator()<4>();
    default:
      return function.template operator()<kAnyDegree>();
  }
}

}  // namespace
}  // namespace shprt
