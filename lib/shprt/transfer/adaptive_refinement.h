// Vertices where a scene's shadows need them: edges are split until transfer interpolated between vertices is
// near the transfer itself.
//
// Level by level, probes are put on the triangles that are new: at the middle of every edge, and, where
// triangles are large, as densely as `coarsest` says. A probe's transfer is compared with what interpolation
// between the corners gives there. An edge is split when the probe at its middle disagrees, and a triangle's
// longest edge when one inside it does. So a floor of two triangles is looked at everywhere, but gets
// vertices only where something shades it. Albedo plays no part.
//
// Probes see few rays. Noise must not pass for a difference: all is baked twice with independent rays, and
// the inner product of the two differences, whose expectation is the true squared difference, decides.
#pragma once

#include <cstdint>
#include <vector>

#include "shprt/base/progress.h"
#include "shprt/scene/refine_scene.h"
#include "shprt/scene/scene.h"

namespace shprt {

struct AdaptiveRefinementOptions {
  // The difference to leave: 2-norm over coefficients of shadowed transfer per unit albedo, over that of the
  // unshadowed transfer.
  double tolerance = 0.06;
  // Lengths in parts of the scene's extent, the largest side of its bounding box: how far apart probes are at
  // most, and the length up to which edges are left alone (shadows that touch what casts them are sharp at
  // every scale).
  double coarsest = 1.0 / 16, finest = 1.0 / 128;
  // No more vertices than growth * (the scene's own) + extraVertices. The largest differences go first.
  double growth = 4;
  std::uint64_t extraVertices = 20'000;
  int degree = 2;
  int rays = 128;  // per vertex and bake, of two
  std::uint64_t seed = 1;
  RefinedObjects objects = RefinedObjects::kReceivers;
};

enum class RefinementStop {
  kTolerance,    // no difference above the tolerance was left
  kFinest,       // where differences were left, edges had become too short
  kVertexLimit,  // the vertices were used up
};

struct RefinementLevel {
  std::uint64_t probes = 0;      // places where transfer was compared
  std::uint64_t edgesSplit = 0;  // because of a difference, or to keep angles and neighbours in order
  double largestDifference = 0;  // as measured, in the units of tolerance
};

struct AdaptiveRefinementReport {
  std::vector<RefinementLevel> levels;
  std::uint64_t verticesBefore = 0, verticesAfter = 0;
  std::uint64_t trianglesBefore = 0, trianglesAfter = 0;
  std::uint64_t rays = 0;  // traced
  // Largest over the edges where refinement ended: those compared and left whole, and those split into halves
  // too short to be compared.
  double remainingDifference = 0;
  RefinementStop stop = RefinementStop::kTolerance;
};

struct AdaptiveRefinement {
  RefinedScene refined;
  AdaptiveRefinementReport report;
};

// Refines the scene's receivers (or all objects). Where nothing stands above any tangent plane there are no
// shadows to carry, and the scene comes back as it is. Edges that are not longer than `finest` come back as
// they are, so a mesh that is finer than that costs no rays; where edges are longer than that, vertices cost
// 2 * rays. progress: bakes done, of a number that is not known (0). Throws Error when Embree fails.
AdaptiveRefinement refineAdaptively(Scene scene, const AdaptiveRefinementOptions& options,
                                    const ProgressCallback& progress = {});

}  // namespace shprt
