// The instruction-set variants behind evaluateShBatch, for its dispatch and for the tests that compare them.
#pragma once

#include <cstddef>
#include <span>

namespace shprt {

using EvaluateBatchFunction = void (*)(int degree, const float* x, const float* y, const float* z,
                                       std::size_t count, float* results, std::size_t stride);

void evaluateShBatchBaseline(int degree, const float* x, const float* y, const float* z, std::size_t count,
                             float* results, std::size_t stride);
#if defined(__x86_64__)
void evaluateShBatchAvx2(int degree, const float* x, const float* y, const float* z, std::size_t count,
                         float* results, std::size_t stride);
void evaluateShBatchAvx512(int degree, const float* x, const float* y, const float* z, std::size_t count,
                           float* results, std::size_t stride);
#endif

struct EvaluateBatchVariant {
  const char* name;
  EvaluateBatchFunction function;
};

// Those that this processor runs, the fastest first.
std::span<const EvaluateBatchVariant> evaluateBatchVariants();

}  // namespace shprt
