#include "shprt/transfer/planned_bake.h"

#include <cassert>

namespace shprt {
namespace {

ShadowedOptions shadowedOptions(const BakeRequest& request) {
  return {.degree = request.degree,
          .rays = request.rays,
          .seed = request.seed,
          .traceEverything = request.traceEverything};
}

// Shadowed transfer of a scene that emits needs hits, too.
InterreflectedOptions interreflectedOptions(const BakeRequest& request) {
  InterreflectedOptions options{.degree = request.degree,
                                .rays = request.rays,
                                .seed = request.seed,
                                .bounces = request.bounces,
                                .error = request.error,
                                .hitMemory = request.hitMemory,
                                .traceEverything = request.traceEverything};
  if (request.model == "shadowed") options.bounces = 0;
  return options;
}

bool needsHits(const PreparedScene& prepared, const BakeRequest& request) {
  assert(request.model == "shadowed" || request.model == "interreflected");
  return request.model == "interreflected" || prepared.scene.emits();
}

}  // namespace

BakeRequest followPlan(const EffectPlan& plan, BakeRequest asked) {
  asked.model = plan.model;
  asked.degree = plan.degree;
  // The plan's number is a prediction; the bake itself sees when enough has bounced.
  if (!asked.bounces && plan.model == "interreflected" && plan.bounces == 0) asked.bounces = 0;
  return asked;
}

Bake bakeRequested(const PreparedScene& prepared, const BakeRequest& request,
                   const ProgressCallback& progress) {
  if (request.model == "unshadowed") return bakeUnshadowed(prepared.scene, request.degree);
  if (!needsHits(prepared, request)) return bakeShadowed(prepared, shadowedOptions(request), progress);
  return bakeInterreflected(prepared, interreflectedOptions(request), progress);
}

FittedBake bakeRequestedFitted(const PreparedScene& prepared, const BakeRequest& request,
                               const FittedOptions& fitting, const ProgressCallback& progress) {
  if (request.model == "unshadowed") {
    FittedBake exact;
    exact.bake = bakeUnshadowed(prepared.scene, request.degree);
    return exact;
  }
  if (!needsHits(prepared, request)) return bakeFitted(prepared, shadowedOptions(request), fitting, progress);
  return bakeFittedInterreflected(prepared, interreflectedOptions(request), fitting, progress);
}

}  // namespace shprt
