#include "shprt/study/measure_costs.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "shprt/study/study_bake.h"

namespace shprt {
namespace {

BakeRequest pilotRequest(const StudyRun& run, const StudyReference& reference) {
  BakeRequest request;
  request.model = reference.traces() ? "interreflected" : "unshadowed";
  request.degree = reference.pilotDegree();
  request.rays = run.options.quick ? 32 : 64;
  request.seed = run.options.seed;
  request.error = reference.bounceError();
  return request;
}

std::vector<DegreeCost> measureDegrees(StudyRun& run, StudyReference& reference) {
  if (!run.light) return {{reference.degree(), 0}};
  // Close below the reference, what is missing beyond it would be taken for nothing.
  const bool whole = reference.degree() == run.light->coefficients.degree &&
                     run.light->coefficients.degree < kMaximumBakeDegree;
  const int most = whole ? reference.degree() : reference.degree() * 3 / 4;
  const std::vector<double> errors = run.journal.measure("pareto/degrees", [&] {
    std::vector<double> measured;
    for (int degree = 0; degree <= most; ++degree) measured.push_back(reference.errorOfDegree(degree));
    return measured;
  });
  std::vector<DegreeCost> costs;
  for (int degree = 0; degree <= most; ++degree)
    costs.push_back({degree, errors[static_cast<std::size_t>(degree)]});
  return costs;
}

// Rays that are few, but the same for all: what differs is what was left out.
std::vector<EffectsCost> measureEffects(StudyRun& run, StudyReference& reference) {
  const int degree = reference.pilotDegree();
  BakeRequest request = pilotRequest(run, reference);
  std::optional<StudyBake> complete;
  const auto measure = [&](const std::string& name, const BakeRequest& lacking) {
    return run.journal.measure("pareto/effects/" + name, [&] {
      const StudyBake bake = bakeForStudy(run, lacking);
      if (lacking.model == "unshadowed")
        return std::vector<double>{reference.errorWithin(degree, bake.asset), 0.0};
      if (!complete) complete = bakeForStudy(run, request);
      return std::vector<double>{reference.difference(degree, bake.asset, complete->asset),
                                 bake.seconds / complete->seconds};
    });
  };
  std::vector<EffectsCost> costs;
  const auto add = [&](const std::string& name, const BakeRequest& lacking) {
    const std::vector<double> measured = measure(name, lacking);
    costs.push_back({lacking.model, lacking.bounces, measured[0], measured[1]});
  };
  BakeRequest lacking = request;
  lacking.model = "unshadowed";
  add("unshadowed", lacking);
  if (!reference.traces()) return costs;
  lacking.model = "shadowed";
  add("shadowed", lacking);
  lacking.model = "interreflected";
  for (const int bounces : {1, 2, 3, 4, 6, 8, 12}) {
    if (costs.back().error < reference.bounceError()) return costs;
    lacking.bounces = bounces;
    add(fmt::format("{}", bounces), lacking);
  }
  lacking.bounces = {};
  lacking.error = BakeRequest{}.error;
  add("auto", lacking);
  return costs;
}

// Measures a setting of the rays against the reference, which has at least four times as many, and keeps it
// unless it is no better than the one before: by chance a step can be upwards. False where there was nothing
// to adapt.
bool addRays(StudyRun& run, StudyReference& reference, const BakeRequest& request,
             std::vector<RayCost>& costs) {
  const double setting = request.samplingError ? errorAskedFor(request) : request.rays;
  const std::vector<double> measured = run.journal.measure(
      fmt::format("pareto/{}/{:g}", request.samplingError ? "adaptive" : "rays", setting), [&] {
        const StudyBake bake = bakeForStudy(run, request);
        return std::vector<double>{reference.errorWithin(request.degree, bake.asset), bake.seconds,
                                   bake.sampling.measured ? 1.0 : 0.0};
      });
  if (request.samplingError && measured[2] == 0) return false;
  if (costs.empty() || measured[0] < costs.back().error) costs.push_back({setting, measured[0], measured[1]});
  return true;
}

std::vector<RayCost> measureFixedRays(StudyRun& run, StudyReference& reference) {
  std::vector<RayCost> costs;
  BakeRequest request = pilotRequest(run, reference);
  for (request.rays = 16; request.rays <= std::min(reference.rays() / 4, 16384); request.rays *= 4)
    addRays(run, reference, request, costs);
  return costs;
}

// As far as the fixed ones go: until as little error is left, or the next would take longer by far.
std::vector<RayCost> measureAdaptiveRays(StudyRun& run, StudyReference& reference,
                                         const std::vector<RayCost>& fixed) {
  constexpr double kStep = 5;  // in seconds, from one error to the next
  std::vector<RayCost> costs;
  BakeRequest request = pilotRequest(run, reference);
  for (const double error : {0.3, 0.1, 0.03, 0.01, 0.003, 0.001}) {
    // Bounces stay complete: what they leave out is a cost of its own.
    request.samplingError = requestForError(request, error).samplingError;
    if (!addRays(run, reference, request, costs)) break;
    if (costs.back().error <= fixed.back().error || costs.back().seconds * kStep > fixed.back().seconds * 2)
      break;
  }
  return costs;
}

std::vector<StorageCost> measureStorage(StudyRun& run, StudyReference& reference) {
  using enum AssetCompression;
  std::optional<StudyBake> bake;
  std::vector<StorageCost> costs;
  for (const bool half : {false, true})
    for (const AssetCompression compression : {kNone, kZip, kPiz}) {
      const WriteAssetOptions storage{half, compression};
      const std::vector<double> measured = run.journal.measure(
          fmt::format("pareto/storage/{}{}", half ? "half-" : "float-", static_cast<int>(compression)), [&] {
            if (!bake) bake = bakeForStudy(run, pilotRequest(run, reference));
            const StoredAsset stored = storeAndRead(bake->asset, storage);
            return std::vector<double>{
                reference.difference(reference.pilotDegree(), stored.asset, bake->asset),
                static_cast<double>(stored.bytes), stored.seconds};
          });
      const double values = coefficientCount(reference.pilotDegree());
      costs.push_back({storage, measured[0], measured[1] / values, measured[2] / values});
    }
  return costs;
}

}  // namespace

ErrorCosts measureErrorCosts(StudyRun& run, StudyReference& reference) {
  ErrorCosts costs;
  run.announce("the best bake, and its degrees");
  costs.degrees = measureDegrees(run, reference);
  run.announce("effects left out");
  costs.effects = measureEffects(run, reference);
  run.announce("errors of few rays");
  if (reference.traces()) {
    costs.rays = measureFixedRays(run, reference);
    costs.adaptive = measureAdaptiveRays(run, reference, costs.rays);
  }
  run.announce("storage");
  costs.storage = measureStorage(run, reference);
  return costs;
}

}  // namespace shprt
