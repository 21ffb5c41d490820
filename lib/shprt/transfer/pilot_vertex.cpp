#include "shprt/transfer/pilot_vertex.h"

#include <time.h>

#include <algorithm>

#include "shprt/sh/accumulate.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

// Seconds that this thread has worked: other programs on the machine do not count.
double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

constexpr std::size_t kClasses = BouncePilot::kBounces + 2;

}  // namespace

PilotTracer::PilotTracer(const PreparedScene& prepared, const HemisphereSet& half,
                         const PilotOptions& options)
    : prepared_(prepared),
      lattice_(half),
      options_(options),
      unshadowed_(options.bandDegree),
      follower_(prepared, options.seed),
      x_(half.paddedCount()),
      y_(x_.size()),
      z_(x_.size()),
      weights_(x_.size()),
      analytic_(static_cast<std::size_t>(coefficientCount(options.bandDegree))),
      basis_(static_cast<std::size_t>(coefficientCount(options.degree))) {
  for (std::vector<double>& direct : direct_) direct.resize(analytic_.size());
  for (Sums& sums : bounced_) sums.resize(kClasses * 3 * basis_.size());
}

PilotVertex PilotTracer::trace(std::uint32_t vertex) {
  PilotVertex result;
  const SurfaceTopology& topology = prepared_.topology;
  const double start = threadSeconds();
  const std::span<const std::uint32_t> meeting = topology.trianglesAt(topology.positionIds()[vertex]);
  const std::vector<std::uint32_t> touching =
      prepared_.caster.trianglesNear(topology.positions()[vertex], topology.contactDistance(), meeting);
  horizon_.prepare(topology, vertex, touching);
  result.seconds.point = threadSeconds() - start;
  unshadowed_.evaluate(topology.normal(vertex), analytic_);
  const IgnoredTriangles ignored{meeting, touching, static_cast<float>(topology.contactDistance())};
  for (const int half : {0, 1}) {
    std::fill(bounced_[half].begin(), bounced_[half].end(), 0.0);
    traceHalf(vertex, half, ignored, result);
  }
  multiplyHalves(result);
  return result;
}

void PilotTracer::traceHalf(std::uint32_t vertex, int half, const IgnoredTriangles& ignored,
                            PilotVertex& result) {
  const Vec3f origin = prepared_.topology.positions()[vertex];
  const Vec3d normal = prepared_.topology.normal(vertex);
  const std::size_t packets = x_.size() / kRayPacketSize;
  const auto packetAt = [&](std::size_t packet) {
    const std::size_t first = packet * kRayPacketSize;
    return RayPacket{&x_[first], &y_[first], &z_[first]};
  };

  // A bake of shadows asks whether anything is hit, a bake of bounces for what is hit first. Both are timed
  // on the same rays; only the second answer is used.
  double start = threadSeconds();
  lattice_.directions(normal, options_.seed, std::uint64_t{vertex} * 2 + static_cast<unsigned>(half),
                      x_.data(), y_.data(), z_.data());
  std::vector<std::uint32_t> hidden(packets), hit(packets);
  std::vector<RayPacketHits> hits(packets);
  for (std::size_t p = 0; p < packets; ++p) {
    hidden[p] = horizon_.empty() ? 0 : horizon_.nearest(packetAt(p), hits[p]);
    hit[p] = prepared_.caster.occluded(origin, packetAt(p), 0xffffu & ~hidden[p], ignored);
  }
  result.seconds.shadowRays += threadSeconds() - start;
  start = threadSeconds();
  for (std::size_t p = 0; p < packets; ++p)
    hit[p] = prepared_.caster.nearest(origin, packetAt(p), 0xffffu & ~hidden[p], ignored, hits[p]);
  result.seconds.nearestRays += threadSeconds() - start;

  int visible = 0;
  for (std::size_t ray = 0; ray < x_.size(); ++ray) {
    const std::size_t p = ray / kRayPacketSize, lane = ray % kRayPacketSize;
    const Vec3d direction = toDouble(Vec3f{x_[ray], y_[ray], z_[ray]});
    const SurfacePoint place{hits[p].triangle[lane], hits[p].u[lane], hits[p].v[lane]};
    std::optional<ReflectingPoint> point;
    if (hidden[p] >> lane & 1u)
      point = follower_.meetNearby(place, direction);
    else if (hit[p] >> lane & 1u)
      point = follower_.meet(place, direction);
    else
      ++visible;
    weights_[ray] = (hidden[p] | hit[p]) >> lane & 1u ? 0.0f : 1.0f;
    if (point) followPath(vertex, half, ray, *point, result);
  }
  const double share = visible / static_cast<double>(x_.size());
  result.visible += share / 2;
  start = threadSeconds();
  sumDirect(half, share);
  result.seconds.terms += threadSeconds() - start;
}

void PilotTracer::followPath(std::uint32_t vertex, int half, std::size_t ray, const ReflectingPoint& first,
                             PilotVertex& result) {
  const std::uint64_t index = (std::uint64_t{vertex} * 2 + static_cast<unsigned>(half)) * x_.size() + ray;
  const LightPath path = follower_.follow(first, index);
  ++result.met;
  const double weight = 1 / static_cast<double>(x_.size());
  result.emission += path.emission * (weight / 2);
  if (!path.reachesSky) return;
  const std::size_t k = std::min(static_cast<std::size_t>(path.bounces), kClasses - 1);
  result.power[k] += path.throughput * (weight / 2);
  ++result.arrived[k];
  evaluateSh(options_.degree, path.direction, basis_);
  const double throughput[3] = {path.throughput.x, path.throughput.y, path.throughput.z};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    double* sums = &bounced_[half][(k * 3 + channel) * basis_.size()];
    for (std::size_t i = 0; i < basis_.size(); ++i) sums[i] += weight * throughput[channel] * basis_[i];
  }
}

// As in shadowed.cpp: share times the analytic transfer, and only the difference from it by rays.
void PilotTracer::sumDirect(int half, double share) {
  std::vector<double>& direct = direct_[half];
  for (float& weight : weights_) weight -= static_cast<float>(share);
  accumulateSh(options_.bandDegree, x_.data(), y_.data(), z_.data(), weights_.data(), weights_.size(),
               direct.data());
  for (std::size_t i = 0; i < direct.size(); ++i)
    direct[i] = share * analytic_[i] + direct[i] / static_cast<double>(x_.size());
}

void PilotTracer::multiplyHalves(PilotVertex& result) const {
  for (int l = 0; l <= options_.bandDegree; ++l) {
    double product = 0;
    for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i)
      product += direct_[0][static_cast<std::size_t>(i)] * direct_[1][static_cast<std::size_t>(i)];
    result.bandProducts.push_back(product);
  }
  for (std::size_t i = 0; i < basis_.size(); ++i)
    result.shadowProduct += (analytic_[i] - direct_[0][i]) * (analytic_[i] - direct_[1][i]);
  if (result.met == 0) return;
  const std::size_t count = basis_.size();
  for (std::size_t i = 0; i < count; ++i) {
    double totals[2][3] = {};
    for (std::size_t k = 1; k < kClasses; ++k)
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const std::size_t at = (k * 3 + channel) * count + i;
        result.products[k] += bounced_[0][at] * bounced_[1][at] / 3;
        for (const int half : {0, 1}) totals[half][channel] += bounced_[half][at];
      }
    const double means[2] = {(totals[0][0] + totals[0][1] + totals[0][2]) / 3,
                             (totals[1][0] + totals[1][1] + totals[1][2]) / 3};
    for (std::size_t channel = 0; channel < 3; ++channel) {
      result.totalProduct += totals[0][channel] * totals[1][channel] / 3;
      result.colourProduct += (totals[0][channel] - means[0]) * (totals[1][channel] - means[1]) / 3;
    }
  }
}

}  // namespace shprt
