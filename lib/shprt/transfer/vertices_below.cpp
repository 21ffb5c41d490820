#include "shprt/transfer/vertices_below.h"

#include <algorithm>

#include "shprt/base/parallel.h"
#include "shprt/transfer/local_horizon.h"

namespace shprt {
namespace {

// Whether anything that touches a point, or stands further away, may hide part of its sky.
bool isBelow(const PreparedScene& prepared, std::size_t point, LocalHorizon& horizon,
             OccluderBounds::Hint& hint) {
  const SurfaceTopology& topology = prepared.topology;
  const std::uint32_t vertex = topology.verticesOfPoint(point).front();
  const Vec3f position = topology.positions()[vertex];
  const std::span<const std::uint32_t> meeting = topology.trianglesAt(topology.positionIds()[vertex]);
  // What touches the point is looked for only where nothing else settles it: that takes most of the time.
  if (prepared.bounds.anythingAbove(position, topology.normal(vertex), {meeting, {}, 0}, hint)) return true;
  horizon.prepare(topology, vertex,
                  prepared.caster.trianglesNear(position, topology.contactDistance(), meeting));
  return !horizon.empty();
}

}  // namespace

VerticesBelow findVerticesBelow(const PreparedScene& prepared) {
  const SurfaceTopology& topology = prepared.topology;
  std::vector<char> above(topology.pointCount());
  parallelForBlocks(above.size(), 64, [&](std::size_t begin, std::size_t end) {
    LocalHorizon horizon;
    OccluderBounds::Hint hint = 0;
    for (std::size_t point = begin; point < end; ++point)
      above[point] = isBelow(prepared, point, horizon, hint);
  });
  VerticesBelow below;
  std::vector<char> counted(above.size());
  for (std::uint32_t vertex = 0; vertex < topology.pointIds().size(); ++vertex) {
    if (!prepared.scene.isReceiver(vertex)) continue;
    ++below.receivers;
    const std::uint32_t point = topology.pointIds()[vertex];
    if (!above[point]) continue;
    below.vertices.push_back(vertex);
    below.points += !counted[point];
    counted[point] = true;
  }
  return below;
}

}  // namespace shprt
