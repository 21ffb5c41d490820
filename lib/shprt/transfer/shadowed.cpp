// Transfer of a diffuse surface under shadows: the mean of visibility times y_lm over cosine-distributed
// directions. Based on: Sloan, Kautz and Snyder 2002, section 4.1 (self-shadowed diffuse transfer).
//
// Directions come from a Fibonacci lattice, shifted at random for every vertex. What is estimated by rays is
// only the difference from a known integral: with a the vertex's visible share, T = a U + mean((V - a) y), U
// being the unshadowed transfer. Vertices that see everything or nothing come out exact, and few rays gain
// most. (a is measured from the same rays, which leaves a bias of the order of the squared error.)

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <mutex>

#include "shprt/base/parallel.h"
#include "shprt/sampling/fibonacci_hemisphere.h"
#include "shprt/scene/ray_caster.h"
#include "shprt/sh/accumulate.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/local_horizon.h"
#include "shprt/transfer/surface_topology.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// The points of one block go through here one after another; buffers are kept.
class VertexBaker {
 public:
  VertexBaker(const SurfaceTopology& topology, const RayCaster& caster, const FibonacciHemisphere& lattice,
              const UnshadowedTransfer& unshadowed, const ShadowedOptions& options)
      : topology_(topology),
        caster_(caster),
        lattice_(lattice),
        unshadowed_(unshadowed),
        options_(options),
        x_(lattice.paddedCount()),
        y_(x_.size()),
        z_(x_.size()),
        weights_(x_.size()),
        visible_(x_.size() / kRayPacketSize),
        transfer_(static_cast<std::size_t>(coefficientCount(options.degree))),
        differences_(transfer_.size()) {}

  // Bakes what all render vertices of a point share. Returns the number of rays that saw the sky.
  int bake(std::size_t point) {
    const std::uint32_t vertex = topology_.verticesOfPoint(point).front();
    const Vec3d normal = topology_.normal(vertex);
    lattice_.directions(normal, options_.seed, vertex, x_.data(), y_.data(), z_.data());
    const int visible = traceVisibility(vertex);
    if (visible == 0) {
      std::fill(transfer_.begin(), transfer_.end(), 0.0);
      return visible;
    }
    unshadowed_.evaluate(normal, transfer_);
    if (visible < options_.rays) addDifference(static_cast<double>(visible) / options_.rays);
    return visible;
  }

  std::span<const double> transfer() const { return transfer_; }
  std::uint64_t raysTraced() const { return raysTraced_; }

 private:
  int traceVisibility(std::uint32_t vertex) {
    const Vec3f origin = topology_.positions()[vertex];
    const std::span<const std::uint32_t> meeting = topology_.trianglesAt(topology_.positionIds()[vertex]);
    const std::vector<std::uint32_t> touching =
        caster_.trianglesNear(origin, topology_.contactDistance(), meeting);
    const IgnoredTriangles ignored{meeting, touching, static_cast<float>(topology_.contactDistance())};
    horizon_.prepare(topology_, vertex, touching);
    int visible = 0;
    for (std::size_t packet = 0; packet < visible_.size(); ++packet) {
      const std::size_t first = packet * kRayPacketSize;
      const RayPacket rays{&x_[first], &y_[first], &z_[first]};
      const int lanes = std::min(kRayPacketSize, options_.rays - static_cast<int>(first));
      std::uint32_t active = (1u << lanes) - 1;
      if (!horizon_.empty()) active &= ~horizon_.hidden(rays);
      if (active) active &= ~caster_.occluded(origin, rays, active, ignored);
      visible_[packet] = active;
      visible += __builtin_popcount(active);
    }
    raysTraced_ += static_cast<std::uint64_t>(options_.rays);
    return visible;
  }

  // transfer = share * unshadowed + mean over rays of (V - share) y.
  void addDifference(double share) {
    for (std::size_t ray = 0; ray < weights_.size(); ++ray) {
      const bool seen = (visible_[ray / kRayPacketSize] >> (ray % kRayPacketSize)) & 1u;
      weights_[ray] =
          ray < static_cast<std::size_t>(options_.rays) ? static_cast<float>((seen ? 1 : 0) - share) : 0.0f;
    }
    accumulateSh(options_.degree, x_.data(), y_.data(), z_.data(), weights_.data(), weights_.size(),
                 differences_.data());
    for (std::size_t i = 0; i < transfer_.size(); ++i) {
      transfer_[i] = share * transfer_[i] + differences_[i] / options_.rays;
    }
  }

  const SurfaceTopology& topology_;
  const RayCaster& caster_;
  const FibonacciHemisphere& lattice_;
  const UnshadowedTransfer& unshadowed_;
  const ShadowedOptions& options_;
  LocalHorizon horizon_;
  std::vector<float> x_, y_, z_, weights_;
  std::vector<std::uint32_t> visible_;  // a bit per ray
  std::vector<double> transfer_, differences_;
  std::uint64_t raysTraced_ = 0;
};

}  // namespace

Bake bakeShadowed(const Scene& scene, const ShadowedOptions& options, const ProgressCallback& progress) {
  const Mesh& mesh = scene.mesh;
  assert(scene.albedo.size() == mesh.positions.size() && !mesh.triangles.empty());
  assert(options.rays >= 1 && options.degree >= 0 && !scene.emits());
  const auto buildStart = Clock::now();
  const SurfaceTopology topology(mesh);
  const RayCaster caster(topology.positions(), topology.triangles());
  Bake bake;
  bake.transfer = makeTransfer(scene.albedo, options.degree);
  bake.statistics.buildSeconds = secondsSince(buildStart);

  const auto traceStart = Clock::now();
  const FibonacciHemisphere lattice(options.rays, kRayPacketSize);
  const UnshadowedTransfer unshadowed(options.degree);
  std::atomic<std::uint64_t> done = 0, rays = 0, visibleRays = 0, baked = 0, points = 0, fullyVisible = 0,
                             fullyHidden = 0;
  std::mutex progressMutex;
  parallelForBlocks(topology.pointCount(), 64, [&](std::size_t begin, std::size_t end) {
    VertexBaker baker(topology, caster, lattice, unshadowed, options);
    for (std::size_t point = begin; point < end; ++point) {
      const auto vertices = topology.verticesOfPoint(point);
      const auto receivers = static_cast<std::uint64_t>(std::count_if(
          vertices.begin(), vertices.end(), [&](std::uint32_t vertex) { return scene.isReceiver(vertex); }));
      if (receivers == 0) continue;
      const int visible = baker.bake(point);
      for (const std::uint32_t vertex : vertices)
        if (scene.isReceiver(vertex))
          storeTransfer(baker.transfer(), scene.albedo[vertex], vertex, bake.transfer);
      ++points;
      baked += receivers;
      visibleRays += static_cast<std::uint64_t>(visible) * receivers;
      if (visible == options.rays) fullyVisible += receivers;
      if (visible == 0) fullyHidden += receivers;
    }
    rays += baker.raysTraced();
    done += end - begin;
    if (!progress) return;
    const std::scoped_lock lock(progressMutex);
    progress({done, topology.pointCount(), rays});
  });

  BakeStatistics& statistics = bake.statistics;
  statistics.traceSeconds = secondsSince(traceStart);
  statistics.embreeBytes = caster.peakMemory();
  statistics.rays = rays;
  statistics.meanVisibility =
      static_cast<double>(visibleRays) / (static_cast<double>(options.rays) * static_cast<double>(baked));
  statistics.fullyVisible = fullyVisible;
  statistics.fullyHidden = fullyHidden;
  statistics.samplePoints = points;
  return bake;
}

}  // namespace shprt
