#include "shprt/transfer/surface_topology.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shprt/base/parallel.h"
#include "shprt/mesh/position_ids.h"
#include "shprt/scene/scene_frame.h"

namespace shprt {
namespace {

// Lists, for each group, the items that belong to it: items of group g are members[starts[g]] to
// members[starts[g+1]].
struct Grouping {
  std::vector<std::uint32_t> starts, members;
};

Grouping groupBy(std::size_t itemCount, const auto& groupOf) {
  std::uint32_t groups = 0;
  for (std::size_t i = 0; i < itemCount; ++i) groups = std::max(groups, groupOf(i) + 1);
  Grouping grouping;
  grouping.starts.assign(groups + 1, 0);
  for (std::size_t i = 0; i < itemCount; ++i) ++grouping.starts[groupOf(i) + 1];
  for (std::size_t g = 0; g < groups; ++g) grouping.starts[g + 1] += grouping.starts[g];
  grouping.members.resize(itemCount);
  std::vector<std::uint32_t> next(grouping.starts.begin(), grouping.starts.end() - 1);
  for (std::size_t i = 0; i < itemCount; ++i)
    grouping.members[next[groupOf(i)]++] = static_cast<std::uint32_t>(i);
  return grouping;
}

}  // namespace

SurfaceTopology::SurfaceTopology(const Mesh& mesh)
    : mesh_(&mesh), positions_(toScene(chooseSceneFrame(mesh.positions), mesh.positions)) {
  parallelInvoke(
      [&] {
        pointIds_ = distinctPointIds(mesh.positions, mesh.normals);
        Grouping points = groupBy(pointIds_.size(), [&](std::size_t vertex) { return pointIds_[vertex]; });
        pointStarts_ = std::move(points.starts);
        pointVertices_ = std::move(points.members);
      },
      [&] {
        positionIds_ = distinctPositionIds(mesh.positions);
        Grouping corners = groupBy(3 * mesh.triangles.size(), [&](std::size_t corner) {
          return positionIds_[mesh.triangles[corner / 3][corner % 3]];
        });
        incidentStarts_ = std::move(corners.starts);
        incident_ = std::move(corners.members);
        for (std::uint32_t& corner : incident_) corner /= 3;
      });

  float largest = 0;
  for (const Vec3f& p : positions_)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  contactDistance_ =
      4 * static_cast<double>(std::numeric_limits<float>::epsilon()) * static_cast<double>(largest);
}

}  // namespace shprt
