// How much light there is, over all points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shprt/transfer/light_rows.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

// RMS over render vertices of the 2-norm of one band of light (LightLayout::Band).
struct BandNorm {
  double receivers = 0, all = 0;  // over the receivers' vertices; over all
};

// One for each band of `light`, which has a row per point. receivers: how many of a point's vertices belong
// to receivers. Sums are of fixed order.
std::vector<BandNorm> bandNorms(const LightRows& light, const LightLayout& layout,
                                const SurfaceTopology& topology, std::span<const std::uint32_t> receivers);

}  // namespace shprt
