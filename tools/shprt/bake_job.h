// The steps of shprt bake, from files to the asset of the whole scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bake_options.h"
#include "console.h"
#include "shprt/coefficients/transfer_asset.h"
#include "shprt/scene/scene.h"
#include "shprt/transfer/adaptive_refinement.h"
#include "shprt/transfer/effect_plan.h"
#include "shprt/transfer/fitted.h"
#include "shprt/transfer/planned_bake.h"

namespace shprt {

struct Refined {
  std::uint64_t verticesBefore = 0, verticesAfter = 0;
  double seconds = 0;
  std::optional<AdaptiveRefinementReport> report;  // of --max-edge auto
};

struct BakeOutcome {
  Scene scene;  // as baked: its mesh is the refined one
  std::optional<Refined> refined;
  std::optional<EffectPlan> plan;
  BakeRequest request;  // what was baked
  Bake bake;
  std::optional<FittedBake> fit;  // its bake moved to `bake`
  double loadSeconds = 0;
};

// Of one vertex, in the pass that made the result; 0 for those that are exact without.
double meanRays(const BakeOutcome& outcome);

// Where the asset of one receiver goes: --output, with --per-mesh the object's name before its suffix.
std::string assetFile(const BakeOptions& options, const SceneObject& object);

// Loads, refines, plans and bakes; inputs are the files named on the command line, which no asset may
// overwrite. Throws Error, Interrupted.
BakeOutcome runBakeSteps(const Console& console, const BakeOptions& options,
                         const std::vector<std::string>& inputs);

// The asset of all vertices, blockers included. Takes the outcome's arrays.
TransferAsset makeAsset(const BakeOptions& options, BakeOutcome& outcome);

}  // namespace shprt
