#include "shprt/study/sampling_curve.h"

#include <fmt/format.h>

#include <cmath>

#include "shprt/study/curve_effort.h"

namespace shprt {

const std::vector<SamplingMethod>& samplingMethods() {
  static const std::vector<SamplingMethod> methods = {
      {"random", "random", PointSet::kRandom, false},
      {"jittered", "jittered", PointSet::kJittered, false},
      {"random-cv", "random, control variate", PointSet::kRandom, true},
      {"jittered-cv", "jittered, control variate", PointSet::kJittered, true},
      {"sobol", "scrambled Sobol, control variate", PointSet::kSobol, true},
      {"lattice", "lattice, control variate", PointSet::kLattice, true}};
  return methods;
}

SamplingMeasurements::SamplingMeasurements(StudyRun& run)
    : run_(run),
      effort_(curveEffort(run.options)),
      sample_(sampleOf(run)),
      emits_(run.prepared.scene.emits()),
      points_(tracedPoints(run.prepared)),
      reference_([this] {
        return sample_.bake({.degree = run_.options.degree,
                             .rays = effort_.referenceRays,
                             .seed = referenceSeed(run_.options)});
      }),
      dark_([this] { return std::make_unique<Dark>(run_.prepared.scene); }) {}

std::string SamplingMeasurements::referenceName() const {
  return fmt::format("degree {}, seed {}, against {} rays at {} vertices", run_.options.degree,
                     run_.options.seed, effort_.referenceRays, sample_.vertices().size());
}

double SamplingMeasurements::errorOf(const TransferCoefficients& transfer) {
  return shareOf(rmsDifference(transfer, reference()),
                 unshadowedRms(run_.prepared.scene, sample_.vertices(), run_.options.degree));
}

ShadowedOptions SamplingMeasurements::optionsOf(const SamplingMethod& method, int rays) const {
  // Without the control variate an unoccluded point is no more exact than any other, so its rays are needed.
  return {.degree = run_.options.degree,
          .rays = rays,
          .seed = run_.options.seed,
          .traceEverything = !method.controlVariate,
          .points = method.points,
          .controlVariate = method.controlVariate};
}

double SamplingMeasurements::error(const SamplingMethod& method, int rays) {
  const std::string key = fmt::format("sampling error: {}, {} rays, {}", method.id, rays, referenceName());
  return run_.journal
      .measure(key, [&] { return std::vector{errorOf(sample_.bake(optionsOf(method, rays)))}; })
      .front();
}

bool SamplingMeasurements::affordable(double raysPerPoint) const {
  return raysPerPoint * static_cast<double>(points_) <= static_cast<double>(effort_.bakeRays);
}

std::optional<double> SamplingMeasurements::seconds(const SamplingMethod& method, int rays) {
  if (!affordable(rays)) return {};
  const std::string key = fmt::format("sampling seconds: {}, {} rays, degree {}, seed {}", method.id, rays,
                                      run_.options.degree, run_.options.seed);
  return run_.journal
      .measure(key,
               [&] {
                 return std::vector{bestSeconds([&] {
                   return bakeShadowed(shadowScene(), optionsOf(method, rays)).statistics.traceSeconds;
                 })};
               })
      .front();
}

std::optional<double> raysForError(const std::vector<std::pair<double, double>>& points, double error) {
  const std::optional<double> slope = fitSlope(points);
  if (!slope || !(*slope < 0) || !(error > 0)) return {};
  const auto along = [error](std::pair<double, double> from, double exponent) {
    return from.first * std::pow(error / from.second, 1 / exponent);
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto &a = points[i], &b = points[i + 1];
    if (a.second >= error && error >= b.second && a.second > b.second && b.second > 0)
      return along(a, std::log(b.second / a.second) / std::log(b.first / a.first));
  }
  const auto& nearest = error > points.front().second ? points.front() : points.back();
  if (!(nearest.second > 0)) return {};
  return along(nearest, *slope);
}

}  // namespace shprt
