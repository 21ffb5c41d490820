// Transfer of a diffuse surface under shadows: the mean of visibility times y_lm over cosine-distributed
// directions. Based on: Sloan, Kautz and Snyder 2002, section 4.1 (self-shadowed diffuse transfer).
//
// Directions come from a Fibonacci lattice, shifted at random for every vertex (hemisphere_tracer.h), and
// only the difference from the unshadowed transfer is estimated by them (direct_transfer.h). Points that lie
// inside other geometry take their transfer from their neighbours (shadowed_burials.h).

#include <algorithm>
#include <atomic>
#include <cassert>
#include <mutex>
#include <numeric>
#include <optional>

#include "shprt/base/parallel.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/buried_search.h"
#include "shprt/transfer/direct_transfer.h"
#include "shprt/transfer/hemisphere_tracer.h"
#include "shprt/transfer/prepared_scene.h"
#include "shprt/transfer/ray_plan.h"
#include "shprt/transfer/shadowed_burials.h"
#include "shprt/transfer/stopwatch.h"
#include "shprt/transfer/surface_topology.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {
namespace {

constexpr std::size_t kBlock = 64;  // points

void measureDirect(DirectTransfer& direct, const HemisphereTracer& tracer, std::size_t point,
                   PointErrors& errors) {
  const bool withRate = point % kRateStride == 0;
  const DirectTransfer::Parts parts = direct.parts(tracer, withRate);
  for (const std::span<const double> contrast : parts.contrasts) addSquares(contrast, point, errors);
  errors.rays[point] = tracer.isUnoccluded() ? 0 : static_cast<std::uint32_t>(tracer.rays());
  if (withRate) storeRate(parts.contrasts, parts.sixteenthSquare, point, errors);
}

}  // namespace

Bake bakeShadowed(const PreparedScene& prepared, std::span<const Vec3f> albedo,
                  const ShadowedOptions& options, const ProgressCallback& progress) {
  const Scene& scene = prepared.scene;
  const SurfaceTopology& topology = prepared.topology;
  assert(albedo.size() == scene.mesh.positions.size() && !scene.mesh.triangles.empty());
  assert(options.rays >= 1 && options.degree >= 0 && !scene.emits());
  Bake bake;
  bake.transfer = makeTransfer(albedo, options.degree);

  const Stopwatch traceWatch;
  std::optional<RayPlan> samePlan;
  if (!options.rayPlan) samePlan.emplace(options.points, options.rays);
  const RayPlan& plan = options.rayPlan ? *options.rayPlan : *samePlan;
  if (options.pointErrors)
    *options.pointErrors = PointErrors(topology.pointCount(), {.channels = 1, .degree = options.degree});
  const UnshadowedTransfer unshadowed(options.degree);
  std::atomic<std::uint64_t> done = 0, rays = 0, baked = 0, points = 0, fullyVisible = 0, fullyHidden = 0,
                             raysSpared = 0, unoccludedPoints = 0;
  std::vector<double> visibility((topology.pointCount() + kBlock - 1) / kBlock);  // sums over vertices
  std::vector<std::uint8_t> isHidden(topology.pointCount());
  std::mutex progressMutex;
  parallelForBlocks(topology.pointCount(), kBlock, [&](std::size_t begin, std::size_t end) {
    // What is spared has no directions, and only the control variate does without them.
    HemisphereTracer tracer(prepared, plan, options.seed, !options.traceEverything && options.controlVariate);
    DirectTransfer direct(options.degree, unshadowed, options.controlVariate);
    std::uint64_t blockRays = 0;
    for (std::size_t point = begin; point < end; ++point) {
      const auto vertices = topology.verticesOfPoint(point);
      const auto receivers = static_cast<std::uint64_t>(std::count_if(
          vertices.begin(), vertices.end(), [&](std::uint32_t vertex) { return scene.isReceiver(vertex); }));
      if (receivers == 0) continue;
      tracer.traceVisibility(point);
      const std::span<const double> transfer = direct.evaluate(tracer);
      for (const std::uint32_t vertex : vertices)
        if (scene.isReceiver(vertex)) storeTransfer(transfer, albedo[vertex], vertex, bake.transfer);
      if (options.pointErrors) measureDirect(direct, tracer, point, *options.pointErrors);
      ++points;
      blockRays += tracer.rays();
      baked += receivers;
      visibility[begin / kBlock] +=
          static_cast<double>(tracer.visible() * receivers) / static_cast<double>(tracer.rays());
      if (tracer.visible() == tracer.rays()) fullyVisible += receivers;
      if (tracer.visible() == 0) fullyHidden += receivers;
      isHidden[point] = RayEnds::isNothing(tracer.visible(), tracer.rays());
    }
    rays += blockRays;
    raysSpared += tracer.raysSpared();
    unoccludedPoints += tracer.unoccludedPoints();
    done += end - begin;
    if (!progress) return;
    const std::scoped_lock lock(progressMutex);
    progress({done, topology.pointCount(), rays});
  });

  BakeStatistics& statistics = bake.statistics;
  std::vector<std::uint32_t> hidden;
  for (std::uint32_t point = 0; point < isHidden.size(); ++point)
    if (isHidden[point]) hidden.push_back(point);
  if (!hidden.empty() || (options.burials && !options.burials->empty())) {
    fillBuried(prepared, plan, options, hidden, [&](std::uint32_t point, std::span<const double> filled) {
      for (const std::uint32_t vertex : topology.verticesOfPoint(point)) {
        if (!scene.isReceiver(vertex)) continue;
        storeTransfer(filled, albedo[vertex], vertex, bake.transfer);
        ++statistics.buriedVertices;
      }
    });
  }

  statistics.buildSeconds = prepared.buildSeconds;
  statistics.traceSeconds = traceWatch.seconds();
  statistics.embreeBytes = prepared.caster.peakMemory();
  statistics.rays = rays;
  statistics.raysSpared = raysSpared;
  statistics.unoccludedPoints = unoccludedPoints;
  statistics.meanVisibility =
      std::accumulate(visibility.begin(), visibility.end(), 0.0) / static_cast<double>(baked);
  statistics.fullyVisible = fullyVisible;
  statistics.fullyHidden = fullyHidden;
  statistics.samplePoints = points;
  return bake;
}

Bake bakeShadowed(const PreparedScene& prepared, const ShadowedOptions& options,
                  const ProgressCallback& progress) {
  return bakeShadowed(prepared, prepared.scene.albedo, options, progress);
}

Bake bakeShadowed(const Scene& scene, const ShadowedOptions& options, const ProgressCallback& progress) {
  return bakeShadowed(PreparedScene(scene), options, progress);
}

}  // namespace shprt
