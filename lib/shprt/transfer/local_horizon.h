// What the triangles that meet at a vertex hide from it, decided exactly and without a length scale.
//
// A ray that starts on a triangle cannot be tested against it by tracing: the answer at distance zero is
// rounding. The usual cure, starting a small epsilon away, needs to know how small "small" is. But seen from
// the vertex itself, each triangle that touches it is an infinite wedge between two directions, and wedges
// look the same at every scale. So: move the vertex an infinitesimal step off its surface, to a point p that
// lies along the direction o, and ask whether the ray from p in direction d meets the wedge. As the ray runs
// from p to infinity its direction seen from the vertex sweeps the arc from o to d, and the wedge hides d
// exactly when that arc crosses the wedge's arc. All other triangles are a finite distance away and are
// traced, from the vertex itself.
//
// The step o depends on what the wedge belongs to:
//  - its own smooth surface (triangles that share this position and this normal): along the normal. A convex
//  surface then
//    hides nothing of the hemisphere, however coarse, and a concave one hides what lies below it.
//  - another surface that touches here (a wall that meets the floor, the other side of a crease): along one
//  of its own
//    triangles, just above it, which is the limit of points inside that triangle. Rays that leave below
//    that triangle's plane, possible where the normal is an average, step along the normal.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/scene/ray_caster.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

class LocalHorizon {
 public:
  // Prepares the wedges around a render vertex. touching: triangles that the vertex lies on without being
  // their corner (within topology.contactDistance()).
  void prepare(const SurfaceTopology& topology, std::uint32_t vertex,
               std::span<const std::uint32_t> touching);

  // Whether nothing that touches the vertex rises above its tangent plane.
  bool empty() const { return wedges_.empty(); }

  // A bit per lane, set when the direction is hidden. Directions are unit and on the normal's side.
  std::uint32_t hidden(const RayPacket& rays) const;

 private:
  // Linear forms of a direction: on which side of the wedge's plane, and inside which of its two edges, it
  // lies.
  struct Wedge {
    Vec3f plane, inside1, inside2;
    // The same forms of the step o: [0] for rays above the own triangle's plane, [1] for rays below it.
    float originPlane[2], originInside1[2], originInside2[2];
  };

  void addWedge(Vec3d edge1, Vec3d edge2, bool own);

  std::vector<Wedge> wedges_;
  Vec3d normal_, facePlane_,
      faceStep_;  // facePlane_: normal of the own triangle chosen, on the normal's side
  Vec3f facePlaneFloat_, normalFloat_;
  // No direction further up is hidden, as a cosine to the normal. Towards what hides rays that step along the
  // normal, all of them descend; other wedges leave no bound, and 1.
  float highest_ = 0;
};

}  // namespace shprt
