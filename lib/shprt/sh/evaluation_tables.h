// Constants of the float kernels, in the order in which those read them; rounded from recurrence.h.
#pragma once

namespace shprt {

inline constexpr int kMaximumFloatDegree = 32;
inline constexpr int kMaximumFloatCoefficients = (kMaximumFloatDegree + 1) * (kMaximumFloatDegree + 1);

struct FloatStep {
  float alpha, norm;
};

struct EvaluationTables {
  FloatStep steps[(kMaximumFloatDegree + 1) * (kMaximumFloatDegree + 2) / 2];  // for each m, for each l >= m

  // The steps of order m, the first of which is band m.
  const FloatStep* order(int m) const { return steps + m * (kMaximumFloatDegree + 1) - m * (m - 1) / 2; }
};

// Built once, thread-safe.
const EvaluationTables& evaluationTables();

}  // namespace shprt
