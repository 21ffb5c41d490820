// The rotation kernels for processors with AVX2.
#include "shprt/sh/rotation_variants.h"

#if defined(__x86_64__)
#define SHPRT_LANE_BYTES 32
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#define SHPRT_STREAM(to, lanes) __builtin_nontemporal_store(lanes, reinterpret_cast<Floats*>(to))
#else
#include <immintrin.h>
#pragma GCC target("avx2,fma")
#define SHPRT_STREAM(to, lanes) _mm256_stream_ps(to, lanes)
#endif

#include "shprt/sh/rotation_kernel.h"
#include "shprt/sh/rotation_kernel_low.h"
#include "shprt/sh/rotation_kernel_many.h"
#include "shprt/sh/rotation_kernel_turns.h"

namespace shprt {

const RotationVariant kRotationAvx2 = {"AVX2",          kScalarLowDegree, isRotationToRounding,
                                       rotateLowKernel, rotateBandKernel, rotateManyBandKernel};

}  // namespace shprt

#if defined(__clang__)
#pragma clang attribute pop
#endif
#endif
