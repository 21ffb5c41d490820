// The rays of one point inside a triangle, as a renderer that shades every pixel would send them: from the
// position on the triangle, cosine-distributed around the normal interpolated between its corners.
//
// The interpolated normal is not the triangle's own, so some of its rays leave below the triangle. Where the
// smooth surface that the normals stand for is convex, such a ray is free; traced naively it runs into the
// mesh's inside, and coarse meshes darken in facets (the shadow terminator). Where the surface is concave,
// the ray runs into the surface at once. So:
//  - Triangles that meet the own one and do not rise above its plane hide nothing: they are ignored, and a
//    flat or convex neighbourhood is clean to the last bit.
//  - A ray that leaves above the own triangle's plane ends on whatever it hits, front or back, as at
//    vertices.
//  - A ray that leaves below it ends at once, where it begins, if a neighbour rises above the plane and the
//    normals turn against the ray's direction (concave along it). Otherwise it passes all backs, which are
//    how it leaves the solid, and ends on a front only.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/sampling/hemisphere_set.h"
#include "shprt/scene/ray_caster.h"
#include "shprt/transfer/facet.h"
#include "shprt/transfer/front_faces.h"
#include "shprt/transfer/prepared_scene.h"
#include "shprt/transfer/surface_samples.h"

namespace shprt {

// For the samples of one block, one after another; buffers are kept. The arguments must outlive the tracer,
// and the lattice's groups must be packets of kRayPacketSize.
class SampleTracer {
 public:
  SampleTracer(const PreparedScene& prepared, const FrontFaces& fronts, const HemisphereSet& lattice,
               std::uint64_t seed);

  // Traces a sample's rays, which (seed, index) fixes, and tells only which of them see the sky.
  void traceVisibility(const SurfaceSample& sample, std::size_t index);
  // The same rays, the same answers, and where the others end.
  void traceHits(const SurfaceSample& sample, std::size_t index);

  // Of the sample traced last.
  Vec3d normal() const { return normal_; }
  std::size_t rays() const { return rays_; }
  std::size_t visible() const { return visible_; }  // rays that see the sky
  bool seesSky(std::size_t ray) const { return hasBit(sky_, ray); }
  // After traceHits: whether a ray ends on a front, and where; the others that do not see the sky end on
  // backs.
  bool seesFront(std::size_t ray) const { return hasBit(front_, ray); }
  SurfacePoint hit(std::size_t ray) const {
    const RayPacketHits& hits = hits_[ray / kRayPacketSize];
    const std::size_t lane = ray % kRayPacketSize;
    return {hits.triangle[lane], hits.u[lane], hits.v[lane]};
  }
  // After traceHits: whether the sample is inside a solid. No ray sees the sky then, and more than half of
  // them end on backs.
  bool isBuried() const { return visible_ == 0 && 2 * fronts_ < rays_; }
  // Unit directions in world space, paddedCount() of the lattice of each.
  const float* x() const { return x_.data(); }
  const float* y() const { return y_.data(); }
  const float* z() const { return z_.data(); }

 private:
  static bool hasBit(const std::vector<std::uint32_t>& bits, std::size_t ray) {
    return (bits[ray / kRayPacketSize] >> (ray % kRayPacketSize)) & 1u;
  }
  template <bool kWithHits>
  void trace(const SurfaceSample& sample, std::size_t index);
  RayPacket packetAt(std::size_t packet) const {
    const std::size_t first = packet * kRayPacketSize;
    return {&x_[first], &y_[first], &z_[first]};
  }
  std::uint32_t belowPlane(const RayPacket& rays) const;
  std::uint32_t frontsAmong(std::size_t packet, std::uint32_t hit);
  std::uint32_t hiddenBelow(Vec3f origin, const SurfaceSample& sample, std::size_t packet,
                            std::uint32_t lanes);

  const SurfaceTopology& topology_;
  const RayCaster& caster_;
  const FrontFaces& frontFaces_;
  const HemisphereSet& lattice_;
  std::uint64_t seed_;
  std::optional<Facet> facet_;
  Vec3d normal_;
  std::size_t rays_, visible_ = 0, fronts_ = 0;
  std::vector<std::uint32_t> touching_, passed_, found_;
  std::vector<float> x_, y_, z_;
  std::vector<std::uint32_t> sky_, front_;  // a bit per ray
  std::vector<RayPacketHits> hits_;         // per packet
};

}  // namespace shprt
