// Averages over neighbours on the surface: for quantities that a single point knows badly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "shprt/transfer/surface_topology.h"

namespace shprt {

// values: `columns` numbers for each point. Replaces each point's by their mean with those at the other ends
// of its triangles' edges, the own counting as two edges; so often. Points with isLeftOut (0 or 1) neither
// change nor count. In a fixed order.
void smoothOverEdges(const SurfaceTopology& topology, std::span<const std::uint8_t> isLeftOut, int times,
                     std::size_t columns, std::span<float> values);

}  // namespace shprt
