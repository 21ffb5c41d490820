#include "shprt/mesh/subdivide.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "shprt/mesh/distinct.h"
#include "shprt/mesh/position_ids.h"
#include "shprt/mesh/triangulate.h"

namespace shprt {
namespace {

// The same bits from either end.
Vec3f midpoint(Vec3f a, Vec3f b) {
  return toFloat((toDouble(a) + toDouble(b)) * 0.5);
}

double squaredDistance(Vec3f a, Vec3f b) {
  const Vec3d d = toDouble(a) - toDouble(b);
  return dot(d, d);
}

// A triangle's parts, whose corners are 0, 1, 2 (its own) and 3, 4, 5 (midpoints of edges 0, 1, 2).
struct Cut {
  int parts = 0;
  std::array<std::array<std::uint8_t, 3>, 4> corners{};

  void add(int a, int b, int c) {
    corners[static_cast<std::size_t>(parts++)] = {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b),
                                                  static_cast<std::uint8_t>(c)};
  }
};

using SixPlaces = std::array<Vec3f, 6>;

// Whether the quadrilateral a b c d is cut from a to c: the shorter diagonal, or that of the first place.
bool cutsFirstDiagonal(Vec3f a, Vec3f b, Vec3f c, Vec3f d) {
  const double first = squaredDistance(a, c), second = squaredDistance(b, d);
  if (first != second) return first < second;
  const auto key = [](Vec3f p) { return std::tuple(p.x, p.y, p.z); };
  return std::min(key(a), key(c)) < std::min(key(b), key(d));
}

Cut cutTriangle(const std::array<bool, 3>& split, const SixPlaces& places) {
  Cut cut;
  const auto count = std::count(split.begin(), split.end(), true);
  if (count == 0) {
    cut.add(0, 1, 2);
  } else if (count == 3) {
    cut.add(0, 3, 5);
    cut.add(1, 4, 3);
    cut.add(2, 5, 4);
    cut.add(3, 4, 5);
  } else {
    // The edge that differs from the other two runs from a to b; c is opposite.
    const auto odd = std::find(split.begin(), split.end(), count == 1) - split.begin();
    const int a = static_cast<int>(odd), b = (a + 1) % 3, c = (a + 2) % 3;
    if (count == 1) {
      cut.add(a, 3 + a, c);
      cut.add(3 + a, b, c);
      return cut;
    }
    const int bc = 3 + b, ca = 3 + c;
    const auto place = [&](int i) { return places[static_cast<std::size_t>(i)]; };
    cut.add(bc, c, ca);
    if (cutsFirstDiagonal(place(a), place(b), place(bc), place(ca))) {
      cut.add(a, b, bc);
      cut.add(a, bc, ca);
    } else {
      cut.add(a, b, ca);
      cut.add(b, bc, ca);
    }
  }
  return cut;
}

// All that cutting one triangle needs to know.
struct SplitTriangle {
  std::array<bool, 3> split{};
  SixPlaces places{};

  SplitTriangle(const Mesh& mesh, const MeshEdges& edges, const std::vector<bool>& marked, std::size_t t) {
    for (std::size_t i = 0; i < 3; ++i) {
      split[i] = marked[edges.ofTriangle[t][i]];
      places[i] = mesh.positions[mesh.triangles[t][i]];
    }
    for (std::size_t i = 0; i < 3; ++i) places[3 + i] = midpoint(places[i], places[(i + 1) % 3]);
  }

  bool any() const { return split[0] || split[1] || split[2]; }

  // Midpoints are rounded, which thin triangles may not survive.
  bool keepsOrientation() const {
    const auto direction = [&](std::size_t a, std::size_t b, std::size_t c) {
      return areaDirection(toDouble(places[a]), toDouble(places[b]), toDouble(places[c]));
    };
    const Vec3d whole = direction(0, 1, 2);
    const Cut cut = cutTriangle(split, places);
    return std::all_of(cut.corners.begin(), cut.corners.begin() + cut.parts, [&](const auto& part) {
      return dot(direction(part[0], part[1], part[2]), whole) > 0;
    });
  }
};

// Sparing an edge changes how its other triangles are cut, so they are judged again.
void spareWhatFloatCannotSplit(const Mesh& mesh, const MeshEdges& edges, std::vector<bool>& marked) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const SplitTriangle triangle(mesh, edges, marked, t);
      if (!triangle.any() || triangle.keepsOrientation()) continue;
      for (const std::uint32_t edge : edges.ofTriangle[t]) marked[edge] = false;
      changed = true;
    }
  }
}

// Towards the side on which the corners' normals are, or else by the order of the corners.
Vec3d frontOf(const Mesh& mesh, const Triangle& triangle) {
  Vec3d corners[3], normals;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = toDouble(mesh.positions[triangle[i]]);
    normals += toDouble(mesh.normals[triangle[i]]);
  }
  const Vec3d direction = normalize(areaDirection(corners[0], corners[1], corners[2]));
  return dot(direction, normals) < 0 ? -direction : direction;
}

void appendMidpoint(Mesh& mesh, std::uint32_t a, std::uint32_t b, const Triangle& triangle) {
  const Vec3d sum = toDouble(mesh.normals[a]) + toDouble(mesh.normals[b]);
  // Below the rounding of unit normals, what is left of two opposite ones is no direction.
  constexpr double kOpposite = 1e-6;
  const Vec3d normal = length(sum) > kOpposite ? normalize(sum) : frontOf(mesh, triangle);
  mesh.positions.push_back(midpoint(mesh.positions[a], mesh.positions[b]));
  mesh.normals.push_back(toFloat(normal));
  if (!mesh.textureCoordinates.empty()) {
    const Vec2f p = mesh.textureCoordinates[a], q = mesh.textureCoordinates[b];
    mesh.textureCoordinates.push_back({p.x / 2 + q.x / 2, p.y / 2 + q.y / 2});
  }
  if (!mesh.colours.empty()) mesh.colours.push_back(midpoint(mesh.colours[a], mesh.colours[b]));
  if (!mesh.vertexMaterials.empty()) mesh.vertexMaterials.push_back(mesh.vertexMaterials[a]);
}

}  // namespace

std::uint32_t MeshEdges::longestOf(std::uint32_t triangle) const {
  std::uint32_t longest = ofTriangle[triangle][0];
  for (const std::uint32_t edge : ofTriangle[triangle]) {
    if (lengths[edge] > lengths[longest] || (lengths[edge] == lengths[longest] && edge < longest))
      longest = edge;
  }
  return longest;
}

MeshEdges findEdges(const Mesh& mesh) {
  const std::vector<std::uint32_t> places = distinctPositionIds(mesh.positions);
  const auto endsOf = [&](std::size_t side) {
    const Triangle& triangle = mesh.triangles[side / 3];
    return std::array{triangle[side % 3], triangle[(side + 1) % 3]};
  };
  const DistinctIds distinct = numberDistinct<2>(3 * mesh.triangles.size(), [&](std::size_t side) {
    const auto [a, b] = endsOf(side);
    return std::array{std::min(places[a], places[b]), std::max(places[a], places[b])};
  });
  MeshEdges edges;
  edges.ofTriangle.resize(mesh.triangles.size());
  for (std::size_t side = 0; side < distinct.ids.size(); ++side)
    edges.ofTriangle[side / 3][side % 3] = distinct.ids[side];
  for (const std::uint32_t side : distinct.firstUse) {
    const auto ends = endsOf(side);
    edges.ends.push_back(ends);
    edges.lengths.push_back(std::sqrt(squaredDistance(mesh.positions[ends[0]], mesh.positions[ends[1]])));
  }
  return edges;
}

void markLongestEdges(const MeshEdges& edges, std::vector<bool>& marked) {
  assert(marked.size() == edges.lengths.size());
  // Each edge that is marked in turn is longer than the one that asked for it, so this ends.
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t t = 0; t < edges.ofTriangle.size(); ++t) {
      double longestMarked = 0;
      for (const std::uint32_t edge : edges.ofTriangle[t])
        if (marked[edge]) longestMarked = std::max(longestMarked, edges.lengths[edge]);
      const std::uint32_t longest = edges.longestOf(t);
      if (longestMarked == 0 || longestMarked == edges.lengths[longest]) continue;
      marked[longest] = changed = true;
    }
  }
}

Subdivision splitEdges(const Mesh& mesh, const MeshEdges& edges, std::vector<bool> marked) {
  assert(edges.ofTriangle.size() == mesh.triangles.size() && marked.size() == edges.lengths.size());
  spareWhatFloatCannotSplit(mesh, edges, marked);

  Subdivision result;
  result.mesh = mesh;
  // One new vertex per pair of render vertices along a split edge.
  std::vector<std::size_t> splitSides;
  for (std::size_t side = 0; side < 3 * mesh.triangles.size(); ++side)
    if (marked[edges.ofTriangle[side / 3][side % 3]]) splitSides.push_back(side);
  const auto pairOf = [&](std::size_t i) {
    const Triangle& triangle = mesh.triangles[splitSides[i] / 3];
    const std::uint32_t a = triangle[splitSides[i] % 3], b = triangle[(splitSides[i] + 1) % 3];
    return std::array{std::min(a, b), std::max(a, b)};
  };
  const DistinctIds pairs = numberDistinct<2>(splitSides.size(), pairOf);
  for (const std::uint32_t first : pairs.firstUse) {
    const std::size_t side = splitSides[first];
    result.vertexParents.push_back(pairOf(first));
    result.vertexEdges.push_back(edges.ofTriangle[side / 3][side % 3]);
    const auto [a, b] = result.vertexParents.back();
    appendMidpoint(result.mesh, a, b, mesh.triangles[side / 3]);
  }

  const auto firstNew = static_cast<std::uint32_t>(mesh.positions.size());
  result.mesh.triangles.clear();
  std::size_t nextSide = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const SplitTriangle triangle(mesh, edges, marked, t);
    std::array<std::uint32_t, 6> vertices{};
    for (std::size_t i = 0; i < 3; ++i) {
      vertices[i] = mesh.triangles[t][i];
      if (triangle.split[i]) vertices[3 + i] = firstNew + pairs.ids[nextSide++];
    }
    const Cut cut = cutTriangle(triangle.split, triangle.places);
    for (int part = 0; part < cut.parts; ++part) {
      const auto& corners = cut.corners[static_cast<std::size_t>(part)];
      result.mesh.triangles.push_back({vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]});
      result.triangleParents.push_back(static_cast<std::uint32_t>(t));
    }
  }
  return result;
}

}  // namespace shprt
