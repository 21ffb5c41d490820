// Transfer whose interpolation over the triangles, not its value at the vertices, is what is right: samples
// over the triangles, and the vertex coefficients that fit them best.
#pragma once

#include <cstdint>

#include "shprt/base/progress.h"
#include "shprt/scene/scene.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/prepared_scene.h"
#include "shprt/transfer/surface_samples.h"
#include "shprt/transfer/vertex_fit.h"

namespace shprt {

struct FittedOptions {
  SampleOptions samples = {};  // their seed counts, not the rays'
  FitOptions fit = {};
};

struct FittedBake {
  Bake bake;                        // statistics.rays and samplePoints count vertices and samples together
  std::uint64_t samples = 0;        // over the triangles
  std::uint64_t buriedSamples = 0;  // of those, inside a solid and left out of the fit
  double sampleSeconds = 0;         // their rays
  double fitSeconds = 0;
  // Per unit albedo, all but `values`, which are in bake.transfer and bake.emission. Light of the scene's own
  // counts in units of the most that a sample receives.
  VertexFit fit;
};

// bakeShadowed at the vertices, where the fit starts; then as many rays from every sample, and the fit, per
// unit albedo. Albedo is a vertex's own. The scene must not emit. The share of the sky that each vertex sees
// is kept between none and all, which the fit alone would not do where a shadow's edge crosses a triangle;
// higher coefficients may still overshoot there.
FittedBake bakeFitted(const PreparedScene& prepared, const ShadowedOptions& shadowed,
                      const FittedOptions& options, const ProgressCallback& progress = {});
FittedBake bakeFitted(const Scene& scene, const ShadowedOptions& shadowed, const FittedOptions& options,
                      const ProgressCallback& progress = {});

// bakeInterreflected at the vertices; then every sample gathers once more (final gather): its own shadowed
// transfer and emitters that it sees, and what surfaces send it of the light that their vertices receive. The
// last bounce thus arrives at samples, not at vertices, and there are no more of them than were asked for.
// What a vertex receives of the sky's mean is kept between none and all, as above, and light of the scene's
// own above none.
FittedBake bakeFittedInterreflected(const PreparedScene& prepared,
                                    const InterreflectedOptions& interreflected, const FittedOptions& options,
                                    const ProgressCallback& progress = {});
FittedBake bakeFittedInterreflected(const Scene& scene, const InterreflectedOptions& interreflected,
                                    const FittedOptions& options, const ProgressCallback& progress = {});

}  // namespace shprt
