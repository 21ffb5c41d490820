// Outgoing radiance by brute force: what a bake and its relighting approximate, with no spherical harmonic
// anywhere.
//
// Paths are traced backwards from a point until they are absorbed. The first rays follow the rules of a bake
// (hemisphere_tracer.h) or, inside triangles, of a renderer that shades every pixel (sample_tracer.h), and so
// do all later ones, from where paths meet fronts; backs are black. So what is left between a bake and this
// is the degree of its harmonics, its rays, its bounces, its storage, and the interpolation between vertices.
// Wherever a path is, the sky is looked for with rays that follow the cosine and rays that follow the sky
// (sky_directions.h).
// Based on: Kajiya 1986 (the rendering equation, solved by paths), Arvo and Kirk 1990 (Russian roulette).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/progress.h"
#include "shprt/base/vec.h"
#include "shprt/transfer/prepared_scene.h"
#include "shprt/transfer/sky_sampler.h"
#include "shprt/transfer/surface_samples.h"

namespace shprt {

struct ReferenceOptions {
  int rays = 256;  // of each of the two kinds, from each point, in one pass; at least 1
  // Independent repetitions, at least 2: estimates are their mean, standard errors come from their scatter.
  int passes = 16;
  std::uint64_t seed = 1;
};

struct RadianceEstimate {
  // Outgoing, linear Rec.709, with all bounces: albedo folded in, the scene's own lights included.
  Vec3d radiance;
  Vec3d standardError;  // of each channel
  // Whether the point seems to lie inside other geometry, where nobody sees it: a bake fills it from its
  // neighbours.
  bool buried = false;
  std::uint64_t surfaces = 0;  // that its paths went on from: what the estimate cost beside its first rays
};

// At render vertices. Unbiased, and the same bits for any number of threads; what a vertex gets depends on
// the seed and itself alone. No kind of geometry is refused.
std::vector<RadianceEstimate> traceRadiance(const PreparedScene& prepared,
                                            std::span<const std::uint32_t> vertices, const Sky& sky,
                                            const ReferenceOptions& options,
                                            const ProgressCallback& progress = {});

// At points inside triangles, around interpolated normals, with the albedo there. What a sample gets depends
// on its index, too.
std::vector<RadianceEstimate> traceRadiance(const PreparedScene& prepared,
                                            std::span<const SurfaceSample> samples, const Sky& sky,
                                            const ReferenceOptions& options,
                                            const ProgressCallback& progress = {});

// RMS of standard errors over RMS of radiance, over points that are not buried and channels; 0 for black.
double relativeStandardError(std::span<const RadianceEstimate> estimates);

}  // namespace shprt
