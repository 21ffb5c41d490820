// Which side of a surface a ray meets: fronts reflect and emit, backs are black.
//
// A triangle's front is the side on which its corners' normals lie, whatever its winding. Two-sided surfaces
// are two triangles back to back, of which a ray may be told either: it belongs to the one that faces it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/mesh/opposite_triangles.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

class FrontFaces {
 public:
  // The topology must outlive it.
  explicit FrontFaces(const SurfaceTopology& topology);

  // The front that a ray of this direction meets where it hits a triangle: there, or at the same place of the
  // triangle that lies back to back with it; none where it meets only a back.
  std::optional<SurfacePoint> facing(const SurfacePoint& hit, Vec3f direction) const;

  Vec3f normal(std::uint32_t triangle) const { return normals_[triangle]; }  // unit, on the front
  // The triangle that lies back to back with this one; itself where there is none.
  std::uint32_t backOf(std::uint32_t triangle) const {
    return opposite_[triangle] == kNoTriangle ? triangle : opposite_[triangle];
  }

 private:
  SurfacePoint onOpposite(const SurfacePoint& hit, std::uint32_t opposite) const;

  const SurfaceTopology& topology_;
  std::vector<Vec3f> normals_;           // per triangle, unit, on the front
  std::vector<std::uint32_t> opposite_;  // per triangle, or kNoTriangle
};

}  // namespace shprt
