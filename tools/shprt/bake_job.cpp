#include "bake_job.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "commands.h"
#include "light_arguments.h"
#include "mesh_report.h"
#include "output.h"
#include "progress_bar.h"
#include "scene_report.h"
#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/base/version.h"
#include "shprt/coefficients/object_ranges.h"
#include "shprt/report/plan_report.h"
#include "shprt/scene/refine_scene.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/stopwatch.h"

namespace shprt {
namespace {

// Of transfer in three channels.
double mostBytes(std::size_t vertices, int degree) {
  return static_cast<double>(vertices) * 3 * coefficientCount(degree) * sizeof(float);
}

// Linux grants memory it does not have and ends the process when it is used; better to say so first.
void checkMemory(const std::string& path, std::size_t vertices, int degree) {
  const double needed = mostBytes(vertices, degree);
  const double present =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (needed <= present) return;
  throw Error(path,
              fmt::format("transfer of degree {} for {} vertices takes {}, more than this machine's {}",
                          degree, formatCount(vertices), formatBytes(static_cast<std::uint64_t>(needed)),
                          formatBytes(static_cast<std::uint64_t>(present))),
              "use a lower --degree");
}

// What overflowed would make an asset that no reader takes.
void checkEmission(const std::string& path, const std::vector<Vec3f>& emission) {
  if (std::all_of(emission.begin(), emission.end(), [](const Vec3f& value) { return isFinite(value); }))
    return;
  throw Error(path, "the light of its lamps is beyond float",
              "make their emission darker, and brighten it with relight --emission or --exposure");
}

// What bounces is refined wherever it reflects; shadows need no more than what is baked.
Refined refine(const BakeOptions& options, Scene& scene) {
  const Stopwatch watch;
  Refined refined;
  refined.verticesBefore = scene.mesh.positions.size();
  const bool bounces = options.effects.automatic || options.effects.interreflection;
  const RefinedObjects objects = bounces ? RefinedObjects::kAll : RefinedObjects::kReceivers;
  if (options.maxEdge->length) {
    scene = splitLongEdges(std::move(scene), *options.maxEdge->length, objects).scene;
  } else {
    AdaptiveRefinement adaptive =
        withProgress("refining", options.common.quiet, [&](const ProgressCallback& progress) {
          return refineAdaptively(std::move(scene), {.seed = options.seed, .objects = objects}, progress);
        });
    scene = std::move(adaptive.refined.scene);
    refined.report = std::move(adaptive.report);
  }
  refined.verticesAfter = scene.mesh.positions.size();
  refined.seconds = watch.seconds();
  return refined;
}

// What effects and bounces may leave out of a bake that is to be as good as its time allows: less than what
// rays leave uncertain, and not so little that finding out takes the time.
constexpr double kTimedOmission = 1e-3;

BakeRequest requestOf(const BakeOptions& options) {
  BakeRequest request;
  request.model = options.effects.interreflection ? "interreflected"
                  : options.effects.shadows       ? "shadowed"
                                                  : "unshadowed";
  request.degree = options.degree.value_or(request.degree);
  request.rays = options.rays;
  request.seed = options.seed;
  request.bounces = options.bounces;
  if (options.wantedError && options.choosesRays()) {
    request = requestForError(request, *options.wantedError);
  } else if (options.wantedError) {
    request.error = *options.wantedError;
  } else if (options.seconds) {
    request.error = kTimedOmission;
  }
  request.measureError = options.errorPart;
  request.hitMemory = options.hitMemory;
  request.traceEverything = options.effects.traceEverything;
  return request;
}

EffectPlan makePlan(const BakeOptions& options, const PreparedScene& prepared,
                    const std::vector<LightCoefficients>& lights) {
  return withProgress("planning", options.common.quiet, [&](const ProgressCallback& progress) {
    return planEffects(prepared, lights,
                       {.degree = options.degree,
                        .rays = options.rays,
                        .seed = options.seed,
                        .error = requestOf(options).error,
                        .hitMemory = options.hitMemory,
                        .half = options.writing.half},
                       progress);
  });
}

// Of transfer that no rays made.
TransferError noError(const TransferCoefficients& transfer) {
  TransferError error{transfer.degree, transfer.channels, transfer.vertexCount, {}};
  error.values.resize(static_cast<std::size_t>(error.channels * error.bands()) * error.vertexCount);
  return error;
}

}  // namespace

double meanRays(const BakeOutcome& outcome) {
  return outcome.request.samplingError || outcome.request.seconds
             ? outcome.bake.statistics.sampling.raysPerVertex
             : outcome.request.rays;
}

std::string assetFile(const BakeOptions& options, const SceneObject& object) {
  if (!options.perMesh) return options.output;
  const std::filesystem::path path(options.output);
  const std::string name = path.filename().string();
  const std::string suffix = name.ends_with(".prt.exr") ? ".prt.exr" : path.extension().string();
  return (path.parent_path() / (name.substr(0, name.size() - suffix.size()) + "_" + object.name + suffix))
      .string();
}

BakeOutcome runBakeSteps(const Console& console, const BakeOptions& options,
                         const std::vector<std::string>& inputs) {
  const Stopwatch watch;
  BakeOutcome outcome;
  const Stopwatch loadWatch;
  outcome.scene = loadScene(options.scene, options.loading);
  outcome.loadSeconds = loadWatch.seconds();
  std::vector<std::filesystem::path> sources = outcome.scene.sources;
  const std::vector<LightCoefficients> lights = loadPlanLights(console, options.lights, {}, sources);
  for (const SceneObject& object : outcome.scene.objects) {
    if (object.role != Role::kReceiver) continue;
    checkOutput(assetFile(options, object), inputs);
    checkNotInput(assetFile(options, object), sources);
    checkDistinct(assetFile(options, object), options.common);
  }
  checkNotInput(options.common.jsonFile, sources);
  if (options.maxEdge) outcome.refined = refine(options, outcome.scene);
  checkMemory(options.scene, outcome.scene.mesh.positions.size(), options.degree.value_or(4));

  const PreparedScene prepared(outcome.scene);
  outcome.request = requestOf(options);
  if (options.effects.automatic) {
    outcome.plan = makePlan(options, prepared, lights);
    outcome.request = followPlan(*outcome.plan, outcome.request);
    // Colours that the plan finds too weak to matter; scenes that are grey stay as they are.
    if (outcome.plan->channels == 1) makeGrey(outcome.scene);
    checkMemory(options.scene, outcome.scene.mesh.positions.size(), outcome.request.degree);
  }
  if (options.seconds) {
    constexpr double kBytesPerSecond = 2e8, kLeastSeconds = 1e-3;
    const double writing =
        mostBytes(outcome.scene.mesh.positions.size(), outcome.request.degree) / kBytesPerSecond;
    outcome.request.seconds = std::max(*options.seconds - watch.seconds() - writing, kLeastSeconds);
  }
  if (options.fit) {
    outcome.fit = withProgress("baking", options.common.quiet, [&](const ProgressCallback& progress) {
      return bakeRequestedFitted(prepared, outcome.request, {}, progress);
    });
    outcome.bake = std::move(outcome.fit->bake);
  } else {
    outcome.bake = withProgress("baking", options.common.quiet, [&](const ProgressCallback& progress) {
      return bakeRequested(prepared, outcome.request, progress);
    });
  }
  checkEmission(options.scene, outcome.bake.emission);
  return outcome;
}

TransferAsset makeAsset(const BakeOptions& options, BakeOutcome& outcome) {
  Scene& scene = outcome.scene;
  const BakeStatistics& statistics = outcome.bake.statistics;
  TransferAsset asset;
  AssetMetadata& metadata = asset.metadata;
  metadata.toolVersion = kVersion;
  metadata.model = outcome.request.model;
  if (metadata.model != "unshadowed") {
    metadata.rays = static_cast<int>(std::lround(meanRays(outcome)));
    metadata.seed = outcome.request.seed;
    const SamplingStatistics& sampling = statistics.sampling;
    if (sampling.measured) {
      metadata.samplingError = sampling.error;
      metadata.samplingErrorBound = sampling.errorBound;
      for (const auto& [rays, number] : sampling.verticesByRays) metadata.verticesByRays[rays] = number;
    }
  }
  if (metadata.model == "interreflected") {
    metadata.bounces = static_cast<int>(statistics.bounces.size());
    metadata.tailSummed = statistics.tailSummed;
  }
  if (outcome.plan) metadata.plan = planToJson(*outcome.plan);
  for (const std::filesystem::path& source : scene.sources)
    metadata.sources.push_back({source.string(), sha256OfFile(source)});
  metadata.seconds = {
      {"load", outcome.loadSeconds}, {"build", statistics.buildSeconds}, {"trace", statistics.traceSeconds}};
  if (outcome.refined) metadata.seconds["refine"] = outcome.refined->seconds;
  if (outcome.fit) metadata.seconds["fit"] = outcome.fit->fitSeconds;
  if (outcome.plan) metadata.seconds["plan"] = outcome.plan->planSeconds;
  if (!statistics.bounces.empty()) metadata.seconds["bounce"] = statistics.bounceSeconds;
  metadata.counts = meshCounts(scene.mesh);
  // Blockers are no part of the asset.
  const auto isReceiver = [&](std::uint32_t vertex) { return scene.isReceiver(vertex); };
  std::uint64_t vertices = 0, triangles = 0;
  for (std::uint32_t v = 0; v < scene.mesh.positions.size(); ++v) vertices += isReceiver(v);
  for (const Triangle& triangle : scene.mesh.triangles) triangles += isReceiver(triangle[0]);
  metadata.counts["vertices"] = vertices;
  metadata.counts["triangles"] = triangles;
  metadata.counts["rays"] = statistics.rays;
  metadata.counts["raysSpared"] = statistics.raysSpared;
  metadata.counts["samplePoints"] = statistics.samplePoints;
  metadata.counts["unoccludedPoints"] = statistics.unoccludedPoints;
  metadata.counts["fullyVisible"] = statistics.fullyVisible;
  metadata.counts["fullyHidden"] = statistics.fullyHidden;
  metadata.counts["buriedVertices"] = statistics.buriedVertices;
  if (metadata.model == "interreflected") metadata.counts["hits"] = statistics.hits;
  if (outcome.refined) {
    metadata.counts["verticesBeforeRefinement"] = outcome.refined->verticesBefore;
    metadata.counts["verticesAfterRefinement"] = outcome.refined->verticesAfter;
  }
  if (outcome.fit) {
    metadata.counts["fitSamples"] = outcome.fit->samples;
    metadata.counts["buriedFitSamples"] = outcome.fit->buriedSamples;
  }
  metadata.notes = describeLoading(scene);
  metadata.notes.push_back("albedo " + describeAlbedo(scene, options.loading));
  if (isSceneFile(options.scene)) {
    std::vector<ObjectRange> objects;
    for (const SceneObject& object : scene.objects) objects.push_back({object.name, object.file, 0, 0});
    metadata.objects = objectRanges(scene.vertexObjects, objects);
  }

  asset.transfer = std::move(outcome.bake.transfer);
  asset.emission = std::move(outcome.bake.emission);
  if (options.errorPart) {
    asset.error = std::move(outcome.bake.error);
    asset.emissionError = std::move(outcome.bake.emissionError);
    if (metadata.model == "unshadowed") {
      asset.error = noError(asset.transfer);
      asset.emissionError.resize(asset.emission.size());
    }
  }
  asset.positions = std::move(scene.mesh.positions);
  asset.normals = std::move(scene.mesh.normals);
  asset.albedo = std::move(scene.albedo);
  asset.textureCoordinates = std::move(scene.mesh.textureCoordinates);
  asset.triangles = std::move(scene.mesh.triangles);
  return asset;
}

}  // namespace shprt
