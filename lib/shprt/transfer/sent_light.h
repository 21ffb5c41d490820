// What surfaces send back of the light that they receive.
#pragma once

#include <span>

#include "shprt/base/vec.h"
#include "shprt/scene/scene.h"
#include "shprt/transfer/hit_store.h"
#include "shprt/transfer/light_rows.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

// One channel where every albedo is grey, else three; emission where the scene emits.
LightLayout lightLayout(const Scene& scene, int degree);

// sent: a row per render vertex, albedo times what its point receives; in textured scenes without the albedo,
// which comes with the hits. received: a row per point.
void sendBack(const Scene& scene, const SurfaceTopology& topology, const LightLayout& layout,
              const LightRows& received, LightRows& sent);

// Mean over `rays` rays of the radiance that surfaces emit where those that hit one end.
Vec3f meanEmission(const Scene& scene, std::span<const CompactHit> hits, std::size_t rays);

}  // namespace shprt
