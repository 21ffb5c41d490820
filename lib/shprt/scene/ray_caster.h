// Triangles that rays can be traced against: the one door to Embree (3 or 4).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

struct RayHit {
  float distance = -1;  // in units of the ray direction's length; negative when nothing was hit
  std::uint32_t triangle = 0;
  float u = 0, v = 0;  // barycentrics of corners 1 and 2
};

inline constexpr int kRayPacketSize = 16;

// Nearest hits of a packet, one lane each; only lanes that hit something hold anything.
struct RayPacketHits {
  std::uint32_t triangle[kRayPacketSize];
  float u[kRayPacketSize], v[kRayPacketSize];
};

// Unit directions of rays from one common origin, one lane each; consecutive in memory.
struct RayPacket {
  const float* x;
  const float* y;
  const float* z;
};

// Triangles a ray passes through because its origin lies on them. What they hide is decided exactly elsewhere
// (transfer/local_horizon.h), so no epsilon has to push the origin off the surface.
struct IgnoredTriangles {
  std::span<const std::uint32_t> meeting;   // those with a corner at the origin, in increasing order
  std::span<const std::uint32_t> touching;  // others that the origin lies on, in increasing order
  // A distance within which every triangle is among the ignored ones. Rays start there: that loses nothing,
  // and spares most of the calls that would tell ignored triangles from others.
  float distance = 0;
};

// Immutable once built; all queries may run from many threads at once.
class RayCaster {
 public:
  // Coordinates should be near the origin and of order one (scene_frame.h). Both arrays are copied. Throws
  // Error when Embree reports a failure.
  RayCaster(std::span<const Vec3f> positions, std::span<const std::array<std::uint32_t, 3>> triangles);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  // For each lane whose bit is set in `active`: sets its bit in the result when any triangle, except the
  // ignored ones, lies along the ray at a distance of at least ignored.distance.
  std::uint32_t occluded(Vec3f origin, const RayPacket& rays, std::uint32_t active,
                         const IgnoredTriangles& ignored) const;

  // The same rays to the nearest triangle that is not ignored: fills hits and returns a bit per lane that has
  // one.
  std::uint32_t nearest(Vec3f origin, const RayPacket& rays, std::uint32_t active,
                        const IgnoredTriangles& ignored, RayPacketHits& hits) const;

  // Nearest hit along one ray, for pictures. direction of any nonzero length.
  RayHit intersect(Vec3f origin, Vec3f direction) const;

  // The triangles nearer to a point than radius, in increasing order, without those excepted, which are given
  // in increasing order.
  std::vector<std::uint32_t> trianglesNear(Vec3f point, double radius,
                                           std::span<const std::uint32_t> except) const;

  // Most memory that Embree held at once, in bytes: its copy of the mesh, the hierarchy and what building it
  // took.
  std::uint64_t peakMemory() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace shprt
