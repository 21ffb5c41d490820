// Which triangles meet at each position, in the frame that rays are traced in.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/mesh/mesh.h"

namespace shprt {

// A place on a triangle: barycentrics u, v of corners 1 and 2.
struct SurfacePoint {
  std::uint32_t triangle = 0;
  float u = 0, v = 0;
};

// A point is a distinct pair of position and normal: what is baked once and shared by the render vertices
// that differ only in texture coordinate or material.
class SurfaceTopology {
 public:
  // The mesh must outlive the topology.
  explicit SurfaceTopology(const Mesh& mesh);

  std::span<const Vec3f> positions() const { return positions_; }              // per vertex, scene frame
  std::span<const std::uint32_t> positionIds() const { return positionIds_; }  // per vertex
  std::span<const std::uint32_t> pointIds() const { return pointIds_; }        // per vertex
  std::span<const Triangle> triangles() const { return mesh_->triangles; }
  const Mesh& mesh() const { return *mesh_; }
  Vec3d normal(std::uint32_t vertex) const { return normalize(toDouble(mesh_->normals[vertex])); }

  std::size_t pointCount() const { return pointStarts_.size() - 1; }
  // The render vertices of a point, in increasing order.
  std::span<const std::uint32_t> verticesOfPoint(std::size_t point) const {
    return std::span(pointVertices_)
        .subspan(pointStarts_[point], pointStarts_[point + 1] - pointStarts_[point]);
  }
  // All triangles with a corner at a position, in increasing order.
  std::span<const std::uint32_t> trianglesAt(std::uint32_t positionId) const {
    return std::span(incident_).subspan(incidentStarts_[positionId],
                                        incidentStarts_[positionId + 1] - incidentStarts_[positionId]);
  }
  // Distance within which a vertex counts as lying on a triangle: the rounding of the coordinates, nothing
  // more.
  double contactDistance() const { return contactDistance_; }

 private:
  const Mesh* mesh_;
  std::vector<Vec3f> positions_;
  std::vector<std::uint32_t> positionIds_, pointIds_;
  std::vector<std::uint32_t> pointStarts_, pointVertices_;
  std::vector<std::uint32_t> incidentStarts_, incident_;
  double contactDistance_ = 0;
};

}  // namespace shprt
