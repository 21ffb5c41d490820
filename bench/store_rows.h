// The bound of evaluation: plain vector stores, in the widest vectors that the processor has.
#pragma once

#include <cstddef>

namespace shprt::bench {

#if defined(__x86_64__) && defined(__GNUC__)
__attribute__((target("avx512f"))) inline void storeRowsAvx512(float* to, std::size_t count) {
  using Vector = float __attribute__((vector_size(64)));
  const Vector value = Vector{} + 1.5f;
  for (std::size_t i = 0; i < count; i += 16) {
    __builtin_memcpy(to + i, &value, sizeof value);
    asm volatile("" ::: "memory");
  }
}
__attribute__((target("avx2"))) inline void storeRowsAvx2(float* to, std::size_t count) {
  using Vector = float __attribute__((vector_size(32)));
  const Vector value = Vector{} + 1.5f;
  for (std::size_t i = 0; i < count; i += 8) {
    __builtin_memcpy(to + i, &value, sizeof value);
    asm volatile("" ::: "memory");
  }
}
#endif

inline void storeRowsBaseline(float* to, std::size_t count) {
  using Vector = float __attribute__((vector_size(16)));
  const Vector value = Vector{} + 1.5f;
  for (std::size_t i = 0; i < count; i += 4) {
    __builtin_memcpy(to + i, &value, sizeof value);
    asm volatile("" ::: "memory");
  }
}

// Writes count floats, a multiple of 16.
inline void storeRows(float* to, std::size_t count) {
#if defined(__x86_64__) && defined(__GNUC__)
  if (__builtin_cpu_supports("avx512f")) return storeRowsAvx512(to, count);
  if (__builtin_cpu_supports("avx2")) return storeRowsAvx2(to, count);
#endif
  storeRowsBaseline(to, count);
}

}  // namespace shprt::bench
