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

#include "shprt/base/parallel.h"
#include "shprt/sampling/fibonacci_hemisphere.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/direct_transfer.h"
#include "shprt/transfer/hemisphere_tracer.h"
#include "shprt/transfer/prepared_scene.h"
#include "shprt/transfer/shadowed_burials.h"
#include "shprt/transfer/stopwatch.h"
#include "shprt/transfer/surface_topology.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {

Bake bakeShadowed(const PreparedScene& prepared, std::span<const Vec3f> albedo,
                  const ShadowedOptions& options, const ProgressCallback& progress) {
  const Scene& scene = prepared.scene;
  const SurfaceTopology& topology = prepared.topology;
  assert(albedo.size() == scene.mesh.positions.size() && !scene.mesh.triangles.empty());
  assert(options.rays >= 1 && options.degree >= 0 && !scene.emits());
  Bake bake;
  bake.transfer = makeTransfer(albedo, options.degree);

  const Stopwatch traceWatch;
  const FibonacciHemisphere lattice(options.rays, kRayPacketSize);
  const UnshadowedTransfer unshadowed(options.degree);
  std::atomic<std::uint64_t> done = 0, rays = 0, visibleRays = 0, baked = 0, points = 0, fullyVisible = 0,
                             fullyHidden = 0, raysSpared = 0, unoccludedPoints = 0;
  std::vector<std::uint8_t> isHidden(topology.pointCount());
  std::mutex progressMutex;
  parallelForBlocks(topology.pointCount(), 64, [&](std::size_t begin, std::size_t end) {
    HemisphereTracer tracer(prepared, lattice, options.seed, !options.traceEverything);
    DirectTransfer direct(options.degree, unshadowed);
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
      ++points;
      blockRays += tracer.rays();
      baked += receivers;
      visibleRays += tracer.visible() * receivers;
      if (tracer.visible() == tracer.rays()) fullyVisible += receivers;
      if (tracer.visible() == 0) fullyHidden += receivers;
      isHidden[point] = tracer.visible() == 0;
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
  if (!hidden.empty()) {
    fillBuried(prepared, lattice, options, hidden, [&](std::uint32_t point, std::span<const double> filled) {
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
      static_cast<double>(visibleRays) / (static_cast<double>(options.rays) * static_cast<double>(baked));
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
