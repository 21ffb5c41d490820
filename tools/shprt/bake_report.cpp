#include "bake_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene_report.h"
#include "shprt/base/parallel.h"
#include "shprt/base/version.h"
#include "shprt/report/plan_report.h"

namespace shprt {
namespace {

std::uint64_t raysTraced(const BakeStatistics& statistics) {
  return statistics.rays - statistics.raysSpared;
}

double raysPerSecond(const BakeStatistics& statistics) {
  return statistics.traceSeconds > 0 ? static_cast<double>(raysTraced(statistics)) / statistics.traceSeconds
                                     : 0;
}

const char* stopName(RefinementStop stop) {
  switch (stop) {
    case RefinementStop::kTolerance:
      return "all differences are small now";
    case RefinementStop::kFinest:
      return "where differences are left, edges are as short as they may be";
    case RefinementStop::kVertexLimit:
      break;
  }
  return "the limit on vertices is reached";
}

void printRefinement(const Console& console, const Refined& refined) {
  console.field("refined", fmt::format("{} to {} vertices in {:.2f} s", formatCount(refined.verticesBefore),
                                       formatCount(refined.verticesAfter), refined.seconds));
  if (!refined.report || refined.report->levels.empty()) return;
  console.field("", fmt::format("{}; {}", countOf(refined.report->levels.size(), "level", "levels"),
                                stopName(refined.report->stop)));
}

// One line for each effect that is called for, and one for the rest.
void printPlan(const Console& console, const EffectPlan& plan) {
  std::string skipped;
  for (const EffectFinding& finding : plan.findings) {
    if (finding.effect == "degree") continue;
    if (finding.needed && finding.simulated) {
      console.field("effect", finding.effect + ": " + finding.evidence);
    } else if (finding.needed) {
      console.note(fmt::format("{} is called for and not simulated yet: {}; leaving it out costs {:.2g}",
                               finding.effect, finding.evidence, finding.contribution.value));
    } else {
      skipped += (skipped.empty() ? "" : ", ") + finding.effect;
    }
  }
  if (!skipped.empty()) console.field("skipped", skipped + " (shprt plan says why)");
}

// Sampling's bound, and what the tool chose to leave out of bounces and effects; what a user leaves out is
// not an error. Errors of different sources add in squares.
double errorInAll(const BakeOutcome& outcome) {
  const BakeStatistics& statistics = outcome.bake.statistics;
  double error = statistics.sampling.errorBound;
  if (!outcome.request.bounces) error = std::hypot(error, statistics.remainder);
  if (!outcome.plan) return error;
  for (const char* effect : {"shadows", "interreflection"}) {
    const EffectFinding& finding = outcome.plan->finding(effect);
    if (!finding.simulated) error = std::hypot(error, finding.contribution.value);
  }
  return error;
}

void printBounces(const Console& console, const BakeStatistics& statistics) {
  if (statistics.bounces.empty()) return;
  const double first = statistics.bounces.front().norm;
  console.field("bounces", fmt::format("{} in {:.2f} s; the first adds {:.2g}% of unshadowed transfer, ratio "
                                       "{:.2f}, {:.2g}% {}",
                                       statistics.bounces.size(), statistics.bounceSeconds, 100 * first,
                                       statistics.spectralRadius, 100 * statistics.remainder,
                                       statistics.tailSummed ? "at most left, which is added as a series"
                                                             : "at most left out"));
  if (statistics.retracedPoints > 0) {
    console.note(
        fmt::format("hits of {} did not fit into memory and were traced anew for every bounce; more "
                    "--memory is faster",
                    countOf(statistics.retracedPoints, "vertex", "vertices")));
  }
}

// The error of sampling, and where the rays went.
void printSampling(const Console& console, const BakeOptions& options, const BakeOutcome& outcome) {
  const BakeStatistics& statistics = outcome.bake.statistics;
  const SamplingStatistics& sampling = statistics.sampling;
  if (!sampling.measured) return;
  const double inAll = errorInAll(outcome);
  std::optional<double> asked;
  if (outcome.request.samplingError) asked = errorAskedFor(outcome.request);
  console.field(
      "error",
      fmt::format("sampling leaves {:.3g}% of unshadowed transfer, at most {:.3g}% with 95% confidence; "
                  "all together at most {:.3g}%{}",
                  100 * sampling.error, 100 * sampling.errorBound, 100 * inAll,
                  asked ? fmt::format(" (asked for {:.3g}%)", 100 * *asked) : ""));
  if (options.bounces || !(options.effects.automatic || options.effects.interreflection))
    console.note(fmt::format("light that {} leaves out is not counted as an error",
                             options.bounces ? "--bounces" : "the choice of effects"));
  if (asked && inAll > *asked) {
    const char* reason = sampling.errorBound <= *outcome.request.samplingError
                             ? "bounces left out weigh more; ask for less"
                         : options.seconds ? "the time was over; give more --time"
                                           : "some vertices have the most rays there are; ask for more";
    console.note(fmt::format("the error asked for was not reached: {}", reason));
  }
  if (sampling.emissionError > 0)
    console.field("",
                  fmt::format("light of the scene's own: {:.3g}% of itself", 100 * sampling.emissionError));
  if (!options.choosesRays()) return;
  std::uint64_t most = 1;
  for (const auto& [rays, vertices] : sampling.verticesByRays) most = std::max(most, vertices);
  std::string label = "rays per vertex";
  for (const auto& [rays, vertices] : sampling.verticesByRays) {
    constexpr std::uint64_t kWidth = 40;
    const std::string bar((kWidth * vertices + most - 1) / most, '#');
    console.field(
        label, fmt::format("{:>6} {} {}", rays == 0 ? "exact" : formatCount(static_cast<std::uint64_t>(rays)),
                           bar, formatCount(vertices)));
    label.clear();
  }
}

Json samplingToJson(const BakeOutcome& outcome) {
  const BakeStatistics& statistics = outcome.bake.statistics;
  const SamplingStatistics& sampling = statistics.sampling;
  Json histogram = Json::array(), passes = Json::array();
  for (const auto& [rays, vertices] : sampling.verticesByRays)
    histogram.push_back({{"rays", rays}, {"vertices", vertices}});
  for (const SamplingPass& pass : sampling.passes)
    passes.push_back({{"rays", pass.rays}, {"seconds", pass.seconds}, {"error", pass.error}});
  Json figures = {{"error", sampling.error},
                  {"errorBound", sampling.errorBound},
                  {"confidence", 0.95},
                  {"rate", sampling.rate},
                  {"emissionError", sampling.emissionError},
                  {"errorInAll", errorInAll(outcome)},
                  {"verticesByRays", histogram},
                  {"passes", passes}};
  if (outcome.request.samplingError) figures["asked"] = errorAskedFor(outcome.request);
  return figures;
}

void printFit(const Console& console, const FittedBake& fit) {
  console.field("fit", fmt::format("{} over the triangles, {} inside other geometry left out; {} vertices "
                                   "fitted in {:.2f} s",
                                   countOf(fit.samples, "sample", "samples"), formatCount(fit.buriedSamples),
                                   formatCount(fit.fit.fittedVertices), fit.fitSeconds));
  if (!fit.fit.converged)
    console.note(fmt::format("the fit stopped after {} steps with {:.2g} of the residual left",
                             fit.fit.iterations, fit.fit.residual));
}

}  // namespace

void printOutcome(const Console& console, const BakeOptions& options, const BakeOutcome& outcome,
                  const AssetMetadata& metadata) {
  const BakeStatistics& statistics = outcome.bake.statistics;
  printScene(console, options.scene, outcome.scene, options.loading);
  if (outcome.refined) printRefinement(console, *outcome.refined);
  console.field("baked", countOf(metadata.counts.at("vertices"), "vertex", "vertices") + ", " +
                             countOf(metadata.counts.at("triangles"), "triangle", "triangles"));
  if (outcome.plan) printPlan(console, *outcome.plan);
  const BakeRequest& request = outcome.request;
  if (request.model == "unshadowed") {
    console.field("model", fmt::format("unshadowed, degree {}", request.degree));
    if (outcome.scene.emits()) {
      console.note(
          "lamps of the scene light nothing but themselves without shadows: add --effects shadows or "
          "--effects all");
    }
    return;
  }
  console.field("model",
                fmt::format("{}, degree {}, {} per vertex, seed {}", request.model, request.degree,
                            options.choosesRays()
                                ? formatCount(static_cast<std::uint64_t>(std::llround(meanRays(outcome)))) +
                                      " rays on average"
                                : countOf(static_cast<std::uint64_t>(request.rays), "ray", "rays"),
                            request.seed));
  std::string rays = fmt::format("{} in {:.2f} s, {:.1f} Mrays/s ({:.2f} s more to build, {} in Embree)",
                                 formatCount(raysTraced(statistics)), statistics.traceSeconds,
                                 raysPerSecond(statistics) * 1e-6, statistics.buildSeconds,
                                 formatBytes(statistics.embreeBytes));
  console.field("rays", rays);
  if (statistics.raysSpared > 0) {
    console.field("",
                  fmt::format("{} more spared: nothing apart from what touches it rises above the tangent "
                              "plane of their point",
                              formatCount(statistics.raysSpared)));
  }
  printBounces(console, statistics);
  printSampling(console, options, outcome);
  if (outcome.fit && outcome.fit->samples > 0) printFit(console, *outcome.fit);
  if (statistics.buriedVertices > 0) {
    console.field("buried", countOf(statistics.buriedVertices, "vertex", "vertices") +
                                " inside other geometry, filled from their neighbours");
  }
  console.field("mean visibility",
                fmt::format("{:.4f}; {} see everything, {} nothing", statistics.meanVisibility,
                            countOf(statistics.fullyVisible, "vertex", "vertices"),
                            formatCount(statistics.fullyHidden)));
}

Json figuresOf(const BakeOptions& options, const BakeOutcome& outcome, const AssetMetadata& metadata,
               const std::vector<std::string>& assets, double seconds) {
  const BakeStatistics& statistics = outcome.bake.statistics;
  Json sources = Json::array(), bounces = Json::array(), outputs = Json::array();
  std::uint64_t bytes = 0;
  for (const SourceFile& source : metadata.sources)
    sources.push_back({{"file", source.file}, {"sha256", source.sha256}});
  for (const BounceStatistics& bounce : statistics.bounces)
    bounces.push_back({{"norm", bounce.norm}, {"seconds", bounce.seconds}});
  for (const std::string& asset : assets) {
    outputs.push_back(asset);
    bytes += fileSize(asset);
  }
  Json figures = {{"command", "bake"},
                  {"version", kVersion},
                  {"output", options.output},
                  {"outputs", outputs},
                  {"outputBytes", bytes},
                  {"model", metadata.model},
                  {"degree", outcome.request.degree},
                  {"channels", outcome.bake.transfer.channels},
                  {"raysPerVertex", metadata.rays},
                  {"seed", metadata.seed},
                  {"threads", threadCount()},
                  {"vertices", metadata.counts.at("vertices")},
                  {"triangles", metadata.counts.at("triangles")},
                  {"meanVisibility", statistics.meanVisibility},
                  {"raysPerSecond", raysPerSecond(statistics)},
                  {"embreeBytes", statistics.embreeBytes},
                  {"bounces", bounces},
                  {"spectralRadius", statistics.spectralRadius},
                  {"remainder", statistics.remainder},
                  {"tailSummed", statistics.tailSummed},
                  {"hitBytes", statistics.hitBytes},
                  {"retracedPoints", statistics.retracedPoints},
                  {"seconds", metadata.seconds},
                  {"totalSeconds", seconds},
                  {"counts", metadata.counts},
                  {"sources", sources},
                  {"notes", metadata.notes}};
  if (statistics.sampling.measured) figures["sampling"] = samplingToJson(outcome);
  if (outcome.plan) figures["plan"] = Json::parse(planToJson(*outcome.plan));
  return figures;
}

}  // namespace shprt
