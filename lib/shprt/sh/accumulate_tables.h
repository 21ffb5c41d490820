// Constants of the accumulation kernels, in the order in which those read them.
#pragma once

namespace shprt {

inline constexpr int kMaximumAccumulateCoefficients = 33 * 33;

struct AccumulateTables {
  float sectoral[33];  // Pi_mm
  float constants[2 * 33 * 32 /
                  2];  // for each m, for each l > m: a and a*b of Pi_lm = a z Pi_{l-1,m} - ab Pi_{l-2,m}
};

// For degree in [0, 32]; built once, thread-safe.
const AccumulateTables& accumulateTables(int degree);

}  // namespace shprt
