// The instruction-set variants behind accumulateSh, for its dispatch and for the tests that compare them.
#pragma once

#include <cstddef>
#include <span>

namespace shprt {

using AccumulateFunction = void (*)(int degree, const float* x, const float* y, const float* z,
                                    const float* weight, std::size_t count, double* sums);

void accumulateShBaseline(int degree, const float* x, const float* y, const float* z, const float* weight,
                          std::size_t count, double* sums);
#if defined(__x86_64__)
void accumulateShAvx2(int degree, const float* x, const float* y, const float* z, const float* weight,
                      std::size_t count, double* sums);
void accumulateShAvx512(int degree, const float* x, const float* y, const float* z, const float* weight,
                        std::size_t count, double* sums);
#endif

struct AccumulateVariant {
  const char* name;
  AccumulateFunction function;
};

// Those that this processor runs, the fastest first.
std::span<const AccumulateVariant> accumulateVariants();

}  // namespace shprt
