#include "shprt/transfer/planned_bake.h"

#include <cassert>
#include <cmath>
#include <type_traits>

#include "shprt/transfer/controlled_bake.h"

namespace shprt {
namespace {

constexpr double kOmissionShare = 0.5;
const double kSamplingShare = std::sqrt(1 - kOmissionShare * kOmissionShare);

ShadowedOptions shadowedOptions(const BakeRequest& request) {
  return {.degree = request.degree,
          .rays = request.rays,
          .seed = request.seed,
          .traceEverything = request.traceEverything,
          .points = request.points};
}

// Shadowed transfer of a scene that emits needs hits, too.
InterreflectedOptions interreflectedOptions(const BakeRequest& request) {
  InterreflectedOptions options{.degree = request.degree,
                                .rays = request.rays,
                                .seed = request.seed,
                                .bounces = request.bounces,
                                .error = request.error,
                                .hitMemory = request.hitMemory,
                                .traceEverything = request.traceEverything,
                                .points = request.points};
  if (request.model == "shadowed") options.bounces = 0;
  return options;
}

bool needsHits(const PreparedScene& prepared, const BakeRequest& request) {
  assert(request.model == "shadowed" || request.model == "interreflected");
  return request.model == "interreflected" || prepared.scene.emits();
}

}  // namespace

BakeRequest requestForError(BakeRequest request, double error) {
  request.error = kOmissionShare * error;
  request.samplingError = kSamplingShare * error;
  return request;
}

double errorAskedFor(const BakeRequest& request) {
  assert(request.samplingError);
  return *request.samplingError / kSamplingShare;
}

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
  const auto bakeAs = [&](auto options, const SamplingPassInput* pass, const ProgressCallback& listener) {
    if (pass) {
      options.rayPlan = &pass->plan;
      options.pointErrors = &pass->errors;
      options.burials = &pass->burials;
      options.seed = pass->seed;
    }
    if constexpr (std::is_same_v<decltype(options), ShadowedOptions>) {
      return bakeShadowed(prepared, options, listener);
    } else {
      return bakeInterreflected(prepared, options, listener);
    }
  };
  const auto bake = [&](const SamplingPassInput* pass, const ProgressCallback& listener) {
    return needsHits(prepared, request) ? bakeAs(interreflectedOptions(request), pass, listener)
                                        : bakeAs(shadowedOptions(request), pass, listener);
  };
  if (!request.samplingError && !request.seconds && !request.measureError) return bake(nullptr, progress);
  SamplingControl control{.points = request.points, .seed = request.seed, .degree = request.degree};
  control.error = request.samplingError;
  control.seconds = request.seconds;
  if (!control.error && !control.seconds) control.rays = request.rays;
  return bakeControlled(
      prepared, control,
      [&](const SamplingPassInput& pass, const ProgressCallback& listener) { return bake(&pass, listener); },
      progress);
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
