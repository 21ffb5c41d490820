// The effect plan that an asset records, in words: what was simulated, what was left out, and why.
#pragma once

#include <string>
#include <vector>

namespace shprt {

struct PlannedEffect {
  std::string effect;  // its name, "effect" where the plan gives none
  std::string what;    // "needed", "skipped: no surface sees another", ...; one line
};

// One entry per effect of AssetMetadata::plan, in its order. Plans are free to grow: fields that are missing
// or of another kind are left out, and so is what is no effect; "" gives none.
std::vector<PlannedEffect> summarisePlan(const std::string& plan);

}  // namespace shprt
