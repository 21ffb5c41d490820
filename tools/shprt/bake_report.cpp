#include "bake_report.h"

#include <fmt/core.h>

#include <algorithm>

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

void printBounces(const Console& console, const BakeStatistics& statistics) {
  if (statistics.bounces.empty()) return;
  const double first = statistics.bounces.front().norm;
  console.field("bounces", fmt::format("{} in {:.2f} s; the first adds {:.2g}% of unshadowed transfer, ratio "
                                       "{:.2f}, {:.2g}% {}",
                                       statistics.bounces.size(), statistics.bounceSeconds, 100 * first,
                                       statistics.spectralRadius, 100 * statistics.remainder,
                                       statistics.tailSummed ? "at most left and summed as a series"
                                                             : "at most left out"));
  if (statistics.retracedPoints > 0) {
    console.note(
        fmt::format("hits of {} did not fit into memory and were traced anew for every bounce; more "
                    "--memory is faster",
                    countOf(statistics.retracedPoints, "vertex", "vertices")));
  }
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
                            countOf(static_cast<std::uint64_t>(request.rays), "ray", "rays"), request.seed));
  std::string rays = fmt::format("{} in {:.2f} s, {:.1f} Mrays/s ({:.2f} s more to build, {} in Embree)",
                                 formatCount(raysTraced(statistics)), statistics.traceSeconds,
                                 raysPerSecond(statistics) * 1e-6, statistics.buildSeconds,
                                 formatBytes(statistics.embreeBytes));
  console.field("rays", rays);
  if (statistics.raysSpared > 0) {
    console.field("", fmt::format("{} more spared: nothing rises above the tangent plane of {}",
                                  formatCount(statistics.raysSpared),
                                  countOf(statistics.unoccludedPoints, "point", "points")));
  }
  printBounces(console, statistics);
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
  if (outcome.plan) figures["plan"] = Json::parse(planToJson(*outcome.plan));
  return figures;
}

}  // namespace shprt
