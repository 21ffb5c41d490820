// Whether anything can stand between a point of a surface and the sky, decided exactly and without sampling.
//
// A ray leaves the point p at an elevation of at least some sine s above its tangent plane. It meets a
// triangle at a distance t no less than the triangle's own distance from p, and at a height s t no more than
// that of the triangle's highest corner. So a triangle whose highest corner is below kFlatElevation times its
// distance is met by no ray above kFlatElevation. Below that lies 1e-8 of the cosine-weighted sky, less than
// float rounds; no ray of a FibonacciHemisphere goes there (its lowest elevation is 2.4e-4).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "shprt/base/vec.h"
#include "shprt/scene/occluder_tree.h"
#include "shprt/scene/ray_caster.h"

namespace shprt {

// As a sine.
inline constexpr double kFlatElevation = 1e-4;

// Immutable once built; all queries may run from many threads at once.
class OccluderBounds {
 public:
  // As RayCaster's: coordinates near the origin and of order one; at least one triangle. Both arrays must
  // outlive it.
  OccluderBounds(std::span<const Vec3f> positions, std::span<const std::array<std::uint32_t, 3>> triangles)
      : tree_(positions, triangles) {}

  // Where an earlier question found its answer. Neighbouring points are mostly below the same triangle: keep
  // one for a run of them. It changes the time, never the answer.
  using Hint = std::uint32_t;

  // Whether a triangle, except the ignored ones, has a corner higher above the plane through position across
  // the unit normal than kFlatElevation times the triangle's distance from position.
  // No: then no ray from position whose elevation sine is at least kFlatElevation meets any of these
  // triangles. Of ignored, the lists count and the distance does not. Heights and distances are computed in
  // double; boxes leave room for their rounding, so the answer is the one that trying all triangles gives.
  bool anythingAbove(Vec3f position, Vec3d normal, const IgnoredTriangles& ignored, Hint& hint) const;

 private:
  OccluderTree tree_;
};

}  // namespace shprt
