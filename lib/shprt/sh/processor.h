// What the processor at hand can do, for choosing among kernels that are compiled for several.
#pragma once

namespace shprt {

// AVX2 with fused multiply-add.
inline bool hasAvx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

// AVX-512 (foundation) beside those.
inline bool hasAvx512() {
#if defined(__x86_64__)
  return hasAvx2() && __builtin_cpu_supports("avx512f");
#else
  return false;
#endif
}

}  // namespace shprt
