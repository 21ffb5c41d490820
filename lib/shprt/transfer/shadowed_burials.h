// Points of a shadowed bake that see nothing because they lie inside other geometry (buried_points.h).
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "shprt/transfer/bake.h"
#include "shprt/transfer/prepared_scene.h"
#include "shprt/transfer/ray_plan.h"

namespace shprt {

// Receives what a buried point gets: shadowed transfer per unit albedo.
using StoreBuried = std::function<void(std::uint32_t point, std::span<const double> transfer)>;

// Finds out which of the points that see nothing (in increasing order) are buried, as an interreflected bake
// does by more rays, and calls store for those that neighbours can fill. Fills their errors as well, where
// options ask for errors: those of their neighbours.
void fillBuried(const PreparedScene& prepared, const RayPlan& plan, const ShadowedOptions& options,
                std::span<const std::uint32_t> hidden, const StoreBuried& store);

}  // namespace shprt
