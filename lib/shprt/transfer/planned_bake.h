// The bake that is asked for by a model's name, or by the effect plan.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "shprt/transfer/bake.h"
#include "shprt/transfer/effect_plan.h"
#include "shprt/transfer/fitted.h"

namespace shprt {

struct BakeRequest {
  std::string model = "interreflected";  // "unshadowed", "shadowed" or "interreflected"
  int degree = 4;
  int rays = 256;  // per vertex
  std::uint64_t seed = 1;
  std::optional<int> bounces = {};  // as InterreflectedOptions
  double error = 0.01;              // as InterreflectedOptions
  std::uint64_t hitMemory = InterreflectedOptions{}.hitMemory;
  bool traceEverything = false;  // as ShadowedOptions
  PointSet points = PointSet::kLattice;
  // Instead of `rays`: as many for each vertex as bring SamplingStatistics::errorBound to this; above 0. Only
  // for bakes without fit.
  std::optional<double> samplingError = {};
  // Instead of `rays`: the least error that a bake of so many seconds can have; above 0.
  std::optional<double> seconds = {};
  bool measureError = false;  // fill Bake::error and SamplingStatistics, whatever fixes the rays
};

// An error that is to cover everything: half of it for what effects and bounces leave out, the rest for
// sampling; squares add up.
BakeRequest requestForError(BakeRequest request, double error);
// The error of such a request.
double errorAskedFor(const BakeRequest& request);

// What the plan recommends, as far as it has a say; the rest as in `asked`. A number of bounces that was
// asked for stays.
BakeRequest followPlan(const EffectPlan& plan, BakeRequest asked);

Bake bakeRequested(const PreparedScene& prepared, const BakeRequest& request,
                   const ProgressCallback& progress = {});

// The same fitted to samples all over the triangles; unshadowed transfer needs no fit and gets none.
FittedBake bakeRequestedFitted(const PreparedScene& prepared, const BakeRequest& request,
                               const FittedOptions& fitting, const ProgressCallback& progress = {});

}  // namespace shprt
