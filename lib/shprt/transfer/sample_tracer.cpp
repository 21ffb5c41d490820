#include "shprt/transfer/sample_tracer.h"

#include <algorithm>
#include <bit>

namespace shprt {

SampleTracer::SampleTracer(const PreparedScene& prepared, const FrontFaces& fronts,
                           const HemisphereSet& lattice, std::uint64_t seed)
    : topology_(prepared.topology),
      caster_(prepared.caster),
      frontFaces_(fronts),
      lattice_(lattice),
      seed_(seed),
      rays_(static_cast<std::size_t>(lattice.count())),
      x_(lattice.paddedCount()),
      y_(x_.size()),
      z_(x_.size()),
      sky_(x_.size() / kRayPacketSize),
      front_(sky_.size()),
      hits_(sky_.size()) {}

void SampleTracer::traceVisibility(const SurfaceSample& sample, std::size_t index) {
  trace<false>(sample, index);
}

void SampleTracer::traceHits(const SurfaceSample& sample, std::size_t index) {
  trace<true>(sample, index);
}

template <bool kWithHits>
void SampleTracer::trace(const SurfaceSample& sample, std::size_t index) {
  if (!facet_ || facet_->triangle() != sample.triangle) facet_.emplace(topology_, sample.triangle);
  const double u = static_cast<double>(sample.u), v = static_cast<double>(sample.v);
  const Vec3f origin = facet_->positionAt(u, v);
  normal_ = facet_->normalAt(u, v);
  lattice_.directions(normal_, seed_, index, x_.data(), y_.data(), z_.data());
  touching_ = caster_.trianglesNear(origin, topology_.contactDistance(), facet_->level());
  passed_ = touching_;
  const IgnoredTriangles ignored{facet_->level(), touching_, static_cast<float>(topology_.contactDistance())};
  visible_ = fronts_ = 0;
  for (std::size_t packet = 0; packet < sky_.size(); ++packet) {
    const RayPacket rays = packetAt(packet);
    const auto lanes =
        static_cast<unsigned>(std::min<std::size_t>(kRayPacketSize, rays_ - packet * kRayPacketSize));
    const std::uint32_t all = (1u << lanes) - 1, below = belowPlane(rays) & all, above = all & ~below;
    std::uint32_t hidden = 0, front = 0;
    if (above) {
      if constexpr (kWithHits) {
        hidden = caster_.nearest(origin, rays, above, ignored, hits_[packet]);
        front = frontsAmong(packet, hidden);
      } else {
        hidden = caster_.occluded(origin, rays, above, ignored);
      }
    }
    if (below) {
      const std::uint32_t ended = hiddenBelow(origin, sample, packet, below);
      hidden |= ended;
      front |= ended;
    }
    sky_[packet] = all & ~hidden;
    front_[packet] = front;
    visible_ += static_cast<std::size_t>(std::popcount(sky_[packet]));
    fronts_ += static_cast<std::size_t>(std::popcount(front));
  }
}

std::uint32_t SampleTracer::belowPlane(const RayPacket& rays) const {
  const Vec3f plane = toFloat(facet_->planeNormal());
  std::uint32_t mask = 0;
  for (int lane = 0; lane < kRayPacketSize; ++lane)
    mask |= (plane.x * rays.x[lane] + plane.y * rays.y[lane] + plane.z * rays.z[lane] < 0 ? 1u : 0u) << lane;
  return mask;
}

// Of the lanes that hit something, those that hit fronts. Their hits become places on those fronts.
std::uint32_t SampleTracer::frontsAmong(std::size_t packet, std::uint32_t hit) {
  RayPacketHits& hits = hits_[packet];
  const RayPacket rays = packetAt(packet);
  std::uint32_t fronts = 0;
  for (int lane = 0; lane < kRayPacketSize; ++lane) {
    if (!((hit >> lane) & 1u)) continue;
    const std::optional<SurfacePoint> front = frontFaces_.facing(
        {hits.triangle[lane], hits.u[lane], hits.v[lane]}, {rays.x[lane], rays.y[lane], rays.z[lane]});
    if (!front) continue;
    fronts |= 1u << lane;
    hits.triangle[lane] = front->triangle, hits.u[lane] = front->u, hits.v[lane] = front->v;
  }
  return fronts;
}

// Of the lanes given, which leave below the plane, those that are hidden; their hits are fronts. A triangle
// shows its back to all rays of an origin or to none, so each one that is found is passed from then on.
std::uint32_t SampleTracer::hiddenBelow(Vec3f origin, const SurfaceSample& sample, std::size_t packet,
                                        std::uint32_t lanes) {
  const RayPacket rays = packetAt(packet);
  RayPacketHits& ends = hits_[packet];
  std::uint32_t hidden = 0;
  const auto endAt = [&](int lane, const SurfacePoint& place) {
    hidden |= 1u << lane;
    ends.triangle[lane] = place.triangle, ends.u[lane] = place.u, ends.v[lane] = place.v;
  };
  for (int lane = 0; lane < kRayPacketSize; ++lane)
    if ((lanes >> lane) & 1u && facet_->isConcaveAlong({rays.x[lane], rays.y[lane], rays.z[lane]}))
      endAt(lane, {sample.triangle, sample.u, sample.v});
  std::uint32_t open = lanes & ~hidden;
  while (open) {
    const IgnoredTriangles ignored{facet_->level(), passed_, static_cast<float>(topology_.contactDistance())};
    RayPacketHits hits;
    open &= caster_.nearest(origin, rays, open, ignored, hits);
    for (int lane = 0; lane < kRayPacketSize; ++lane) {
      if (!((open >> lane) & 1u)) continue;
      if (facesFront(topology_, hits.triangle[lane], origin)) {
        endAt(lane, {hits.triangle[lane], hits.u[lane], hits.v[lane]});
        open &= ~(1u << lane);
      } else {
        found_.push_back(hits.triangle[lane]);
      }
    }
    for (const std::uint32_t triangle : found_) {
      const auto place = std::lower_bound(passed_.begin(), passed_.end(), triangle);
      if (place == passed_.end() || *place != triangle) passed_.insert(place, triangle);
    }
    found_.clear();
  }
  return hidden;
}

}  // namespace shprt
