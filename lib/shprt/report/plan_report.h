// The effect plan for people and for programs; docs/effects.md documents both.
#pragma once

#include <string>

#include "shprt/transfer/effect_plan.h"

namespace shprt {

// A table of at most 110 columns, one row per effect and more where its evidence is long, and one line that
// says what the bake will be. Lines end in a newline.
std::string formatPlan(const EffectPlan& plan);

// A JSON object on one line: what AssetMetadata::plan holds.
std::string planToJson(const EffectPlan& plan);

}  // namespace shprt
