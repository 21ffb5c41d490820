#include "shprt/transfer/reference_radiance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "shprt/base/parallel.h"
#include "shprt/sampling/random.h"
#include "shprt/transfer/hit_tracer.h"
#include "shprt/transfer/sample_tracer.h"
#include "shprt/transfer/sky_directions.h"

namespace shprt {
namespace {

// Rays of each kind from where a path goes on: with those of a packet it finds the sky far better than with
// one, at little more than its time.
constexpr int kLaterRays = kRayPacketSize / 2;

// Roulette begins after this many surfaces, lets no path live on with more certainty than this, and lifts the
// throughput of those that do to at least a half.
constexpr int kCertainSurfaces = 1;
constexpr double kMostSurvival = 0.95;

// Where a ray ends right at the vertex it left, on a triangle that touches it, several triangles meet, and no
// path can go on: it does so from a hundredth of the way to the triangle's middle.
constexpr float kNearby = 0.01f;

// Directions inside triangles must not be those at the vertex of the same index.
constexpr std::uint64_t kSampleStream = 0x7265666572656e63;

Vec3d times(Vec3d a, Vec3f b) {
  return {a.x * static_cast<double>(b.x), a.y * static_cast<double>(b.y), a.z * static_cast<double>(b.z)};
}

class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t index) : seed_(hashCounter(~seed, index)) {}
  std::uint64_t bits() { return hashCounter(seed_, counter_++); }
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

 private:
  std::uint64_t seed_, counter_ = 0;
};

// What all threads share.
struct Surroundings {
  const PreparedScene& prepared;
  SkyDirections first, later;
  RayPlan firstPlan{first};

  Surroundings(const PreparedScene& scene, const Sky& sky, const ReferenceOptions& options)
      : prepared(scene), first(sky, options.rays, options.rays), later(sky, kLaterRays, kLaterRays) {}
};

// Paths from where they meet a surface; one per thread at a time.
class PathTail {
 public:
  explicit PathTail(const Surroundings& surroundings)
      : scene_(surroundings.prepared.scene),
        directions_(surroundings.later),
        tracer_(surroundings.prepared, surroundings.prepared.fronts(), directions_, 0) {}

  // That paths went on from since this was last asked.
  std::uint64_t takeSurfaces() { return std::exchange(surfaces_, 0); }

  // Radiance that the front at `place` sends back. At each surface every ray looks for the sky, and one of
  // those that meet fronts is followed, for all of them.
  Vec3d radiance(SurfacePoint place, RandomStream& random) {
    Vec3d sum, throughput{1, 1, 1};
    for (int surfaces = 1;; ++surfaces) {
      sum += times(throughput, scene_.materialOf(place.triangle).emission);
      throughput = times(throughput, scene_.albedoAt(place.triangle, place.u, place.v));
      const double brightness = std::max({throughput.x, throughput.y, throughput.z});
      if (brightness <= 0) return sum;
      if (surfaces > kCertainSurfaces) {
        const double survival = std::min(kMostSurvival, 2 * brightness);
        if (random.uniform() >= survival) return sum;
        throughput = throughput / survival;
      }
      ++surfaces_;
      tracer_.traceHits({place.triangle, place.u, place.v, 0}, random.bits());
      const Vec3d sky = directions_.skyLight(tracer_, tracer_.normal());
      sum += {throughput.x * sky.x, throughput.y * sky.y, throughput.z * sky.z};
      onFronts_.clear();
      for (std::size_t ray = 0; ray < directions_.cosineCount(); ++ray)
        if (tracer_.seesFront(ray)) onFronts_.push_back(ray);
      if (onFronts_.empty()) return sum;
      const auto fronts = static_cast<double>(onFronts_.size());
      throughput *= fronts / static_cast<double>(directions_.cosineCount());
      place = tracer_.hit(onFronts_[static_cast<std::size_t>(random.uniform() * fronts)]);
    }
  }

 private:
  const Scene& scene_;
  const SkyDirections& directions_;
  SampleTracer tracer_;
  std::vector<std::size_t> onFronts_;
  std::uint64_t surfaces_ = 0;
};

struct Gathered {
  Vec3d radiance;  // outgoing
  bool buried;
  std::uint64_t surfaces;
};

// Light at points of one kind, in one pass; one per thread at a time.
class VertexGatherer {
 public:
  VertexGatherer(const Surroundings& surroundings, std::span<const std::uint32_t> vertices,
                 std::uint64_t seed)
      : prepared_(surroundings.prepared),
        vertices_(vertices),
        seed_(seed),
        directions_(surroundings.first),
        tracer_(prepared_.scene, prepared_.fronts(),
                HemisphereTracer(prepared_, surroundings.firstPlan, seed, false)),
        tail_(surroundings) {}

  Gathered gather(std::size_t i) {
    const std::uint32_t vertex = vertices_[i];
    const std::size_t point = prepared_.topology.pointIds()[vertex];
    RandomStream random(seed_, prepared_.topology.verticesOfPoint(point).front());
    hits_ = {};
    const bool buried = tracer_.trace(point, hits_).isLikelyBuried();
    const HemisphereTracer& rays = tracer_.rays();
    Vec3d received = directions_.skyLight(rays, rays.normal());
    const double weight = 1 / static_cast<double>(directions_.cosineCount());
    for (std::size_t ray = 0; ray < directions_.cosineCount(); ++ray) {
      if (rays.seesSky(ray)) continue;
      if (const auto place = prepared_.fronts().facing(rays.hit(ray), rays.direction(ray)))
        received += tail_.radiance(clearOf(vertex, *place), random) * weight;
    }
    const Scene& scene = prepared_.scene;
    return {times(received, scene.albedo[vertex]) +
                toDouble(scene.materials[scene.mesh.vertexMaterials[vertex]].emission),
            buried, tail_.takeSurfaces()};
  }

 private:
  SurfacePoint clearOf(std::uint32_t vertex, SurfacePoint place) const {
    const SurfaceTopology& topology = prepared_.topology;
    const auto& [a, b, c] = topology.triangles()[place.triangle];
    const auto at = [&](std::uint32_t corner) { return toDouble(topology.positions()[corner]); };
    const Vec3d corners[3] = {at(a), at(b), at(c)};
    const Vec3d position = interpolate(corners, static_cast<double>(place.u), static_cast<double>(place.v));
    if (length(position - at(vertex)) > 2 * topology.contactDistance()) return place;
    return {place.triangle, place.u + (1.0f / 3 - place.u) * kNearby,
            place.v + (1.0f / 3 - place.v) * kNearby};
  }

  const PreparedScene& prepared_;
  std::span<const std::uint32_t> vertices_;
  std::uint64_t seed_;
  const SkyDirections& directions_;
  HitTracer tracer_;
  PathTail tail_;
  BlockHits hits_;
};

class SampleGatherer {
 public:
  SampleGatherer(const Surroundings& surroundings, std::span<const SurfaceSample> samples, std::uint64_t seed)
      : scene_(surroundings.prepared.scene),
        samples_(samples),
        seed_(hashCounter(seed, kSampleStream)),
        directions_(surroundings.first),
        tracer_(surroundings.prepared, surroundings.prepared.fronts(), directions_, seed_),
        tail_(surroundings) {}

  Gathered gather(std::size_t i) {
    const SurfaceSample& sample = samples_[i];
    RandomStream random(seed_, i);
    tracer_.traceHits(sample, i);
    Vec3d received = directions_.skyLight(tracer_, tracer_.normal());
    const double weight = 1 / static_cast<double>(directions_.cosineCount());
    for (std::size_t ray = 0; ray < directions_.cosineCount(); ++ray)
      if (tracer_.seesFront(ray)) received += tail_.radiance(tracer_.hit(ray), random) * weight;
    return {times(received, scene_.albedoAt(sample.triangle, sample.u, sample.v)) +
                toDouble(scene_.materialOf(sample.triangle).emission),
            tracer_.isBuried(), tail_.takeSurfaces()};
  }

 private:
  const Scene& scene_;
  std::span<const SurfaceSample> samples_;
  std::uint64_t seed_;
  const SkyDirections& directions_;
  SampleTracer tracer_;
  PathTail tail_;
};

RadianceEstimate meanOf(std::span<const Gathered> passes) {
  const auto count = static_cast<double>(passes.size());
  RadianceEstimate estimate;
  estimate.buried = true;
  for (const Gathered& pass : passes) {
    estimate.radiance += pass.radiance / count;
    estimate.buried &= pass.buried;
    estimate.surfaces += pass.surfaces;
  }
  Vec3d squares;
  for (const Gathered& pass : passes) {
    const Vec3d apart = pass.radiance - estimate.radiance;
    squares += {apart.x * apart.x, apart.y * apart.y, apart.z * apart.z};
  }
  const auto errorOf = [&](double sum) { return std::sqrt(sum / (count * (count - 1))); };
  estimate.standardError = {errorOf(squares.x), errorOf(squares.y), errorOf(squares.z)};
  return estimate;
}

template <typename Gatherer, typename Points>
std::vector<RadianceEstimate> trace(const PreparedScene& prepared, Points points, const Sky& sky,
                                    const ReferenceOptions& options, const ProgressCallback& progress) {
  assert(options.rays >= 1 && options.passes >= 2);
  const Surroundings surroundings(prepared, sky, options);
  const auto passes = static_cast<std::size_t>(options.passes);
  std::vector<RadianceEstimate> estimates(points.size());
  std::uint64_t done = 0;
  std::mutex progressMutex;
  parallelForBlocks(points.size(), 4, [&](std::size_t begin, std::size_t end) {
    std::vector<Gathered> gathered((end - begin) * passes);
    for (std::size_t pass = 0; pass < passes; ++pass) {
      Gatherer gatherer(surroundings, points, hashCounter(options.seed, pass));
      for (std::size_t i = begin; i < end; ++i) gathered[(i - begin) * passes + pass] = gatherer.gather(i);
    }
    for (std::size_t i = begin; i < end; ++i)
      estimates[i] = meanOf(std::span(gathered).subspan((i - begin) * passes, passes));
    const std::scoped_lock lock(progressMutex);
    done += end - begin;
    const auto raysPerPoint =
        static_cast<std::uint64_t>(options.passes) * 2 * static_cast<std::uint64_t>(options.rays);
    if (progress) progress({done, points.size(), done * raysPerPoint});
  });
  return estimates;
}

}  // namespace

std::vector<RadianceEstimate> traceRadiance(const PreparedScene& prepared,
                                            std::span<const std::uint32_t> vertices, const Sky& sky,
                                            const ReferenceOptions& options,
                                            const ProgressCallback& progress) {
  return trace<VertexGatherer>(prepared, vertices, sky, options, progress);
}

std::vector<RadianceEstimate> traceRadiance(const PreparedScene& prepared,
                                            std::span<const SurfaceSample> samples, const Sky& sky,
                                            const ReferenceOptions& options,
                                            const ProgressCallback& progress) {
  return trace<SampleGatherer>(prepared, samples, sky, options, progress);
}

double relativeStandardError(std::span<const RadianceEstimate> estimates) {
  double noise = 0, power = 0;
  for (const RadianceEstimate& estimate : estimates) {
    if (estimate.buried) continue;
    noise += dot(estimate.standardError, estimate.standardError);
    power += dot(estimate.radiance, estimate.radiance);
  }
  return power > 0 ? std::sqrt(noise / power) : 0;
}

}  // namespace shprt
