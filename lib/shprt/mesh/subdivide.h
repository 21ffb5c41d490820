// Finer meshes of the same shape: edges are split at their midpoints, and nothing else moves.
//
// An edge is named by the two places it joins, so all triangles along it, whichever render vertices they use
// (seams, hard edges, the two sides of a sheet), are split alike and no crack appears. How a triangle is cut
// depends on where its corners are and on nothing else: a triangle and its reversed twin are cut alike.
// Based on: Rivara 1984 (splitting a triangle's longest edge along with any other keeps angles from
// degenerating).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shprt/mesh/mesh.h"

namespace shprt {

inline constexpr std::uint64_t kMaxRefinedTriangles = 20'000'000;

struct MeshEdges {
  std::vector<std::array<std::uint32_t, 3>> ofTriangle;  // edge i joins corners i and i+1
  std::vector<std::array<std::uint32_t, 2>> ends;  // per edge, the render vertices that one triangle has
  std::vector<double> lengths;                     // per edge, in the mesh's units

  std::uint32_t longestOf(std::uint32_t triangle) const;  // of equally long ones the first in number
};

// Numbered in order of first use.
MeshEdges findEdges(const Mesh& mesh);

// Marks what else should be split so that every triangle that is split is split at its longest edge. `marked`
// holds one entry per edge.
void markLongestEdges(const MeshEdges& edges, std::vector<bool>& marked);

struct Subdivision {
  // Begins with all vertices of the original, unchanged. Positions, texture coordinates and colours of new
  // ones are the means of their parents'; so are normals, normalised (or, where they cancel, a triangle's).
  Mesh mesh;
  std::vector<std::array<std::uint32_t, 2>>
      vertexParents;                           // per new vertex; indices are smaller than its own
  std::vector<std::uint32_t> triangleParents;  // per triangle, the triangle of the original that holds it
  std::vector<std::uint32_t> vertexEdges;      // per new vertex, the edge it halves (from splitEdges alone)
};

// Splits each marked edge once (one entry per edge). Left whole are edges at which float coordinates cannot
// do it: where some triangle would get a part without area, or one that is turned over.
Subdivision splitEdges(const Mesh& mesh, const MeshEdges& edges, std::vector<bool> marked);

// Splits until no edge of a wanted triangle is longer than maxEdge (except those that splitEdges leaves
// whole). wanted: one entry per triangle; none means all. Triangles that are not wanted are split only along
// edges shared with wanted ones. Throws Error, before memory is taken, when maxEdge is not a length or the
// result would have more than maxTriangles.
Subdivision splitLongEdges(const Mesh& mesh, double maxEdge, const std::vector<bool>& wanted = {},
                           std::uint64_t maxTriangles = kMaxRefinedTriangles);

// How many triangles splitLongEdges makes of the wanted ones (to rounding), in at most `limit` steps: where
// that does not do, the count so far, which is at least `limit`.
double countSplitTriangles(const Mesh& mesh, double maxEdge, const std::vector<bool>& wanted,
                           std::uint64_t limit);

}  // namespace shprt
