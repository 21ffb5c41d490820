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
//  surface then hides nothing of the hemisphere, however coarse, and a concave one hides what lies below it.
//  - another surface that touches here (a wall that meets the floor, the other side of a crease): along one
//  of its own triangles, just above it, which is the limit of points inside that triangle. Rays that leave
//  below that triangle's plane, possible where the normal is an average, step along the normal.
//
// Along which of its own triangles, the vertex leaves open where something stands on its surface: on the line
// where a box stands on a floor, some of the floor's triangles go on outside the box, where they are lit, and
// some inside, where nobody sees them. So there is a list of steps, and whoever asks chooses the first from
// which something is seen. Under a wall without thickness both sides can be seen and differ: one vertex
// cannot hold both, and the list's order, widest angle first, decides between them.
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
  // Prepares the wedges around a render vertex, seen from its first step. touching: triangles that the vertex
  // lies on without being their corner (within topology.contactDistance()).
  void prepare(const SurfaceTopology& topology, std::uint32_t vertex,
               std::span<const std::uint32_t> touching);

  // The number of steps that may see different things, at least 1: along own triangles in order of decreasing
  // angle at the vertex; only where other surfaces rise above the vertex; without those along such a surface,
  // which stand on neither side of it, while there are others; and without those within some 10 degrees of an
  // earlier one, which nearly always see the same.
  std::size_t stepCount();
  // From here on answers are those seen from this step; less than stepCount().
  void stepAlong(std::size_t step);

  // Whether nothing that touches the vertex rises above its tangent plane.
  bool empty() const { return wedges_.empty(); }

  // A bit per lane, set when the direction is hidden. Directions are unit and on the normal's side.
  std::uint32_t hidden(const RayPacket& rays) const;

  // The same bits, and for each of them what the ray meets first: of the wedges it crosses the nearest to
  // where it starts. The place is that of the vertex on that wedge's triangle.
  std::uint32_t nearest(const RayPacket& rays, RayPacketHits& hits) const;

 private:
  // Linear forms of a direction: on which side of the wedge's plane, and inside which of its two edges, it
  // lies.
  struct Wedge {
    Vec3f plane, inside1, inside2;
    // The same forms of the step o: [0] for rays above the own triangle's plane, [1] for rays below it.
    float originPlane[2], originInside1[2], originInside2[2];
  };

  // What one triangle takes of the directions around the vertex: those between two of them.
  struct Sector {
    Vec3d edge1, edge2;
    bool own;
    SurfacePoint place;

    double cosine() const;  // of the angle between them
    bool isStep() const;    // whether the vertex may step into it
  };
  // Along an own triangle: its normal, on the side of the vertex's, and the direction of the step.
  struct Step {
    Vec3d plane, direction;
  };

  Step stepInto(const Sector& sector) const;
  void listSteps();
  void addSectorsOfTouching(const SurfaceTopology& topology, Vec3d here, std::uint32_t triangle);
  void makeWedges(const Step& step);
  void addWedge(const Sector& sector);
  template <bool kWithHits>
  std::uint32_t crossWedges(const RayPacket& rays, RayPacketHits* hits) const;

  std::vector<Sector> sectors_;
  std::vector<Step> steps_;  // empty until asked for
  bool othersRise_ = false;  // whether some wedge is not of the own surface
  bool alongWedge_ = false;  // whether the step goes along such a wedge, on neither side of it
  std::vector<Wedge> wedges_;
  std::vector<SurfacePoint> places_;  // per wedge, where on its triangle the vertex is
  Vec3d normal_;
  Step step_;
  Vec3f facePlaneFloat_, normalFloat_;
  // No direction further up is hidden, as a cosine to the normal. Towards what hides rays that step along the
  // normal, all of them descend; other wedges leave no bound, and 1.
  float highest_ = 0;
};

}  // namespace shprt
