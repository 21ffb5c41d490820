// A few vertices, or a few points inside triangles, that stand for a whole scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shprt/scene/scene.h"
#include "shprt/transfer/surface_samples.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

// `count` of the receivers' vertices, in increasing order, one at random of each of as many equal runs in the
// mesh's order; all of them where there are no more.
std::vector<std::uint32_t> spreadVertices(const Scene& scene, std::size_t count, std::uint64_t seed);

// `count` points uniform over the area of the receivers, one at random of each of as many equal shares of
// area in the mesh's order; each stands for its share. None where receivers have no area.
std::vector<SurfaceSample> spreadSamples(const Scene& scene, const SurfaceTopology& topology,
                                         std::size_t count, std::uint64_t seed);

}  // namespace shprt
