#include "shprt/transfer/facet.h"

#include <algorithm>
#include <iterator>

namespace shprt {
namespace {

Vec3d position(const SurfaceTopology& topology, std::uint32_t vertex) {
  return toDouble(topology.positions()[vertex]);
}

// A normal of the plane, of any length, on the side where the corners' normals are.
Vec3d frontNormal(const SurfaceTopology& topology, std::uint32_t triangle) {
  const auto& [a, b, c] = topology.triangles()[triangle];
  const Vec3d corner = position(topology, a);
  const Vec3d crossed = cross(position(topology, b) - corner, position(topology, c) - corner);
  const bool inverted = dot(crossed, topology.normal(a) + topology.normal(b) + topology.normal(c)) < 0;
  return inverted ? -crossed : crossed;
}

}  // namespace

Facet::Facet(const SurfaceTopology& topology, std::uint32_t triangle)
    : triangle_(triangle), planeNormal_(normalize(frontNormal(topology, triangle))) {
  const Triangle& corners = topology.triangles()[triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    positions_[k] = position(topology, corners[k]);
    normals_[k] = topology.normal(corners[k]);
  }
  const Vec3d edge1 = positions_[1] - positions_[0], edge2 = positions_[2] - positions_[0];
  const Vec3d crossed = cross(edge1, edge2);
  // A triangle without area has no plane: all its rays count as above it.
  if (const double square = dot(crossed, crossed); square > 0) {
    gradientU_ = cross(edge2, crossed) / square;
    gradientV_ = cross(crossed, edge1) / square;
  }

  const auto rises = [&](std::uint32_t other) {
    const Triangle& t = topology.triangles()[other];
    return other != triangle && std::any_of(t.begin(), t.end(), [&](std::uint32_t vertex) {
             return dot(position(topology, vertex) - positions_[0], planeNormal_) >
                    topology.contactDistance();
           });
  };
  const auto at = [&](std::size_t k) { return topology.trianglesAt(topology.positionIds()[corners[k]]); };
  std::vector<std::uint32_t> two;
  std::set_union(at(0).begin(), at(0).end(), at(1).begin(), at(1).end(), std::back_inserter(two));
  std::set_union(two.begin(), two.end(), at(2).begin(), at(2).end(), std::back_inserter(level_));
  rises_ = std::erase_if(level_, rises) > 0;
}

Vec3d Facet::normalAt(double u, double v) const {
  const Vec3d normal = normalize(interpolate(normals_, u, v));
  return normal == Vec3d{} ? planeNormal_ : normal;
}

bool Facet::isConcaveAlong(Vec3d direction) const {
  if (!rises_) return false;
  const Vec3d along = direction - planeNormal_ * dot(direction, planeNormal_);
  const Vec3d turn = (normals_[1] - normals_[0]) * dot(gradientU_, along) +
                     (normals_[2] - normals_[0]) * dot(gradientV_, along);
  return dot(turn, along) < 0;
}

bool facesFront(const SurfaceTopology& topology, std::uint32_t triangle, Vec3f point) {
  const Vec3d corner = position(topology, topology.triangles()[triangle][0]);
  return dot(toDouble(point) - corner, frontNormal(topology, triangle)) > 0;
}

}  // namespace shprt
