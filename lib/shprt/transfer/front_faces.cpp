#include "shprt/transfer/front_faces.h"

#include "shprt/base/parallel.h"

namespace shprt {

FrontFaces::FrontFaces(const SurfaceTopology& topology)
    : topology_(topology),
      normals_(topology.triangles().size()),
      opposite_(oppositeTriangles(topology.mesh())) {
  parallelForBlocks(normals_.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t triangle = begin; triangle < end; ++triangle) {
      const auto& [a, b, c] = topology.triangles()[triangle];
      const auto position = [&](std::uint32_t vertex) { return toDouble(topology.positions()[vertex]); };
      const Vec3d normal = normalize(cross(position(b) - position(a), position(c) - position(a)));
      const Vec3d side = topology.normal(a) + topology.normal(b) + topology.normal(c);
      normals_[triangle] = toFloat(dot(normal, side) < 0 ? -normal : normal);
    }
  });
}

std::optional<SurfacePoint> FrontFaces::facing(const SurfacePoint& hit, Vec3f direction) const {
  if (dot(normals_[hit.triangle], direction) < 0) return hit;
  const std::uint32_t opposite = opposite_[hit.triangle];
  if (opposite == kNoTriangle || !(dot(normals_[opposite], direction) < 0)) return std::nullopt;
  return onOpposite(hit, opposite);
}

SurfacePoint FrontFaces::onOpposite(const SurfacePoint& hit, std::uint32_t opposite) const {
  const Triangle &from = topology_.triangles()[hit.triangle], &to = topology_.triangles()[opposite];
  const float weights[3] = {1 - hit.u - hit.v, hit.u, hit.v};
  const auto weightAt = [&](std::uint32_t vertex) {
    const auto ids = topology_.positionIds();
    for (std::size_t k = 0; k < 2; ++k)
      if (ids[from[k]] == ids[vertex]) return weights[k];
    return weights[2];
  };
  return {opposite, weightAt(to[1]), weightAt(to[2])};
}

}  // namespace shprt
