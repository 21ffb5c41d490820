#include "shprt/transfer/hemisphere_tracer.h"

#include <algorithm>

namespace shprt {

HemisphereTracer::HemisphereTracer(const PreparedScene& prepared, const RayPlan& plan, std::uint64_t seed,
                                   bool spare)
    : topology_(prepared.topology),
      caster_(prepared.caster),
      bounds_(prepared.bounds),
      plan_(plan),
      seed_(seed),
      spare_(spare) {}

void HemisphereTracer::traceVisibility(std::size_t point) {
  trace<false>(point);
}

void HemisphereTracer::traceHits(std::size_t point) {
  trace<true>(point);
}

void HemisphereTracer::traceHitsFrom(std::size_t step) {
  castRaysFrom<true>(step);
}

template <bool kWithHits>
void HemisphereTracer::trace(std::size_t point) {
  set_ = &plan_.set(point);
  rays_ = static_cast<std::size_t>(set_->count());
  packets_ = set_->paddedCount() / kRayPacketSize;
  if (sky_.size() < packets_) {
    sky_.resize(packets_);
    for (std::vector<float>* coordinate : {&x_, &y_, &z_}) coordinate->resize(set_->paddedCount());
  }
  if (kWithHits && hits_.size() < packets_) hits_.resize(packets_);
  const std::uint32_t vertex = topology_.verticesOfPoint(point).front();
  normal_ = topology_.normal(vertex);
  origin_ = topology_.positions()[vertex];
  meeting_ = topology_.trianglesAt(topology_.positionIds()[vertex]);
  touching_ = caster_.trianglesNear(origin_, topology_.contactDistance(), meeting_);
  horizon_.prepare(topology_, vertex, touching_);
  open_ = spare_ && !bounds_.anythingAbove(origin_, normal_, {meeting_, touching_, 0}, hint_);
  if (open_) raysSpared_ += rays_;
  if (open_ && horizon_.empty()) {
    ++unoccludedPoints_;
    std::fill_n(sky_.begin(), packets_, ~0u);
    visible_ = rays_;
    return;
  }
  set_->directions(normal_, seed_, vertex, x_.data(), y_.data(), z_.data());
  castRays<kWithHits>();
  if (visible_ > 0) return;
  for (std::size_t step = 1; step < horizon_.stepCount(); ++step) {
    castRaysFrom<kWithHits>(step);
    if (visible_ > 0) return;
  }
  if (horizon_.stepCount() > 1) castRaysFrom<kWithHits>(0);
}

template <bool kWithHits>
void HemisphereTracer::castRaysFrom(std::size_t step) {
  horizon_.stepAlong(step);
  castRays<kWithHits>();
}

template <bool kWithHits>
void HemisphereTracer::castRays() {
  const IgnoredTriangles ignored{meeting_, touching_, static_cast<float>(topology_.contactDistance())};
  visible_ = 0;
  for (std::size_t packet = 0; packet < packets_; ++packet) {
    const std::size_t first = packet * kRayPacketSize;
    const RayPacket rays{&x_[first], &y_[first], &z_[first]};
    const std::size_t lanes = std::min<std::size_t>(kRayPacketSize, rays_ - first);
    std::uint32_t active = (1u << lanes) - 1;
    if constexpr (kWithHits) {
      if (!horizon_.empty()) active &= ~horizon_.nearest(rays, hits_[packet]);
      if (active && !open_) active &= ~caster_.nearest(origin_, rays, active, ignored, hits_[packet]);
    } else {
      if (!horizon_.empty()) active &= ~horizon_.hidden(rays);
      if (active && !open_) active &= ~caster_.occluded(origin_, rays, active, ignored);
    }
    sky_[packet] = active;
    visible_ += static_cast<std::size_t>(__builtin_popcount(active));
  }
}

}  // namespace shprt
