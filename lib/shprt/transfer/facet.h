// One triangle as seen from points inside it: its plane, its interpolated normals, and what meets it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/transfer/surface_samples.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

class Facet {
 public:
  Facet(const SurfaceTopology& topology, std::uint32_t triangle);

  std::uint32_t triangle() const { return triangle_; }
  // At barycentrics u, v: the float position nearest to the exact one, and the unit normal between the
  // corners' (the plane's, where those cancel).
  Vec3f positionAt(double u, double v) const { return toFloat(interpolate(positions_, u, v)); }
  Vec3d normalAt(double u, double v) const;

  // Unit normal of the plane, on the side where the corners' normals are.
  Vec3d planeNormal() const { return planeNormal_; }
  // The triangle itself and those that share a corner position with it and do not rise above its plane, in
  // increasing order: they hide nothing from points on it.
  std::span<const std::uint32_t> level() const { return level_; }
  // Whether the surface bends up along a direction: some triangle that shares a corner position rises above
  // the plane, and the interpolated normals turn against the direction.
  bool isConcaveAlong(Vec3d direction) const;

 private:
  std::uint32_t triangle_;
  Vec3d positions_[3], normals_[3];
  Vec3d planeNormal_, gradientU_, gradientV_;  // gradients of the barycentrics
  std::vector<std::uint32_t> level_;
  bool rises_ = false;
};

// Whether a point lies on the side of a triangle's plane where its corners' normals are.
bool facesFront(const SurfaceTopology& topology, std::uint32_t triangle, Vec3f point);

}  // namespace shprt
