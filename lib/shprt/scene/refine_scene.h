// A scene whose mesh is made finer: what the mesh room does to edges (mesh/subdivide.h), with albedo, objects
// and materials carried along.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shprt/mesh/subdivide.h"
#include "shprt/scene/scene.h"

namespace shprt {

enum class RefinedObjects {
  kReceivers,  // what is baked
  kAll         // blockers too: they reflect light by their vertices
};

struct RefinedScene {
  Scene scene;  // begins with all vertices of the original, unchanged
  std::vector<std::array<std::uint32_t, 2>>
      vertexParents;                           // per new vertex; indices are smaller than its own
  std::vector<std::uint32_t> triangleParents;  // per triangle, the triangle of the original that holds it
};

// Whether the rules of `objects` let a triangle be refined; one entry per triangle.
std::vector<bool> trianglesToRefine(const Scene& scene, RefinedObjects objects);

// The scene on a subdivision of its own mesh. New vertices take their albedo from the material's texture
// where there is one, else the mean of their parents'.
Scene onSubdivision(Scene scene, Subdivision&& subdivision);

// Splits until no edge of those objects is longer than maxEdge, in scene units; other objects are split only
// along edges they share with those. Throws Error as splitLongEdges for a mesh.
RefinedScene splitLongEdges(Scene scene, double maxEdge, RefinedObjects objects = RefinedObjects::kReceivers,
                            std::uint64_t maxTriangles = kMaxRefinedTriangles);

}  // namespace shprt
