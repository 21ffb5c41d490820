// The rays of one point: cosine-distributed over the hemisphere around its normal, and where they end.
//
// What touches the point hides directions by wedges, exactly (local_horizon.h); all other triangles are
// traced from the point itself at distance zero, unless none of them rises above the point's tangent plane
// (scene/occluder_bounds.h).
//
// Where other surfaces touch the point, some of its own triangles may go on inside them (local_horizon.h).
// Its rays start at the first of its steps from which any of them sees the sky, so that what is lit outside a
// box is lit up to the line where the box stands; and where none sees the sky, at the first step.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/scene/occluder_bounds.h"
#include "shprt/scene/ray_caster.h"
#include "shprt/transfer/local_horizon.h"
#include "shprt/transfer/prepared_scene.h"
#include "shprt/transfer/ray_plan.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

// For the points of one block, one after another; buffers are kept. The arguments must outlive the tracer.
class HemisphereTracer {
 public:
  // spare: leave out rays that cannot meet anything; it changes the time, never the answer.
  HemisphereTracer(const PreparedScene& prepared, const RayPlan& plan, std::uint64_t seed, bool spare);

  // Traces the point's rays, which (seed, its first render vertex) fixes, and tells only which of them see
  // the sky.
  void traceVisibility(std::size_t point);
  // The same rays, the same answers, and where each of the others ends.
  void traceHits(std::size_t point);
  // The rays of the point traced last, from one of its steps (less than stepCount()), whatever is seen there.
  std::size_t stepCount() { return horizon_.stepCount(); }
  void traceHitsFrom(std::size_t step);

  // Of the point traced last.
  Vec3d normal() const { return normal_; }
  std::size_t rays() const { return rays_; }
  // Whether it is exact, with nothing above its tangent plane.
  bool isUnoccluded() const { return open_ && horizon_.empty(); }
  std::span<const std::uint8_t> quarters() const { return set_->quarters(); }  // HemisphereSet
  std::span<const std::uint8_t> sixteenths() const { return set_->sixteenths(); }
  std::size_t visible() const { return visible_; }  // rays that see the sky
  bool seesSky(std::size_t ray) const { return (sky_[ray / kRayPacketSize] >> (ray % kRayPacketSize)) & 1u; }
  // Where a ray that does not see the sky ends; after traceHits.
  SurfacePoint hit(std::size_t ray) const {
    const RayPacketHits& hits = hits_[ray / kRayPacketSize];
    const std::size_t lane = ray % kRayPacketSize;
    return {hits.triangle[lane], hits.u[lane], hits.v[lane]};
  }
  // Unit directions in world space, paddedCount() of the point's set of each.
  const float* x() const { return x_.data(); }
  const float* y() const { return y_.data(); }
  const float* z() const { return z_.data(); }
  Vec3f direction(std::size_t ray) const { return {x_[ray], y_[ray], z_[ray]}; }

  // Of all points so far.
  std::uint64_t raysSpared() const { return raysSpared_; }              // decided without being traced
  std::uint64_t unoccludedPoints() const { return unoccludedPoints_; }  // whose rays were all spared

 private:
  template <bool kWithHits>
  void trace(std::size_t point);
  template <bool kWithHits>
  void castRays();
  template <bool kWithHits>
  void castRaysFrom(std::size_t step);

  const SurfaceTopology& topology_;
  const RayCaster& caster_;
  const OccluderBounds& bounds_;
  const RayPlan& plan_;
  std::uint64_t seed_;
  bool spare_;
  OccluderBounds::Hint hint_ = 0;
  std::uint64_t raysSpared_ = 0, unoccludedPoints_ = 0;
  const HemisphereSet* set_ = nullptr;
  std::size_t rays_ = 0, packets_ = 0, visible_ = 0;
  Vec3d normal_;
  Vec3f origin_;
  std::span<const std::uint32_t> meeting_;
  std::vector<std::uint32_t> touching_;
  bool open_ = false;  // whether only what touches the point can hide anything
  LocalHorizon horizon_;
  // For the most rays so far.
  std::vector<float> x_, y_, z_;
  std::vector<std::uint32_t> sky_;   // a bit per ray
  std::vector<RayPacketHits> hits_;  // per packet; empty until traceHits
};

}  // namespace shprt
