// Transfer and emission inside triangles, where sample_tracer.h sends its rays: what the fit is made to.
// A convex mesh comes out exactly unshadowed at its interpolated normals, however coarse.
//
// Samples that are inside a solid (no ray sees the sky, and more than half of them end on backs) are told
// apart: nobody sees that part of the surface, and its darkness should not reach the part that is seen.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/progress.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/light_rows.h"
#include "shprt/transfer/prepared_scene.h"
#include "shprt/transfer/surface_samples.h"

namespace shprt {

struct SampleTransfer {
  SampleValues transfer;              // per unit albedo; what its rows hold, the function says
  std::uint64_t rays = 0;             // traced
  std::vector<std::uint32_t> buried;  // samples inside a solid, in increasing order
  double meanVisibility = 1;          // mean over area of the visible share of the cosine-weighted hemisphere
};

// Shadowed transfer: coefficientCount(degree) rows. options.rays cosine-distributed rays from each sample,
// estimated as in shadowed.cpp. Same bits for any number of threads.
SampleTransfer bakeSamples(const PreparedScene& prepared, std::span<const SurfaceSample> samples,
                           const ShadowedOptions& options, const ProgressCallback& progress = {});

// The same and what surfaces send to the samples, once (final gather): layout.columns() rows, transfer of
// each channel and what arrives of the scene's own lights. layout is lightLayout of the scene and
// options.degree; sent is what sendBack gives (sent_light.h).
SampleTransfer gatherSamples(const PreparedScene& prepared, std::span<const SurfaceSample> samples,
                             const ShadowedOptions& options, const LightLayout& layout, const LightRows& sent,
                             const ProgressCallback& progress = {});

}  // namespace shprt
