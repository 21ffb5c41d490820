// The one directional light, with an even rest, that shades diffuse surfaces most like a given light: for
// renderers that want a sun with shadows from a probe.
#pragma once

#include <array>

#include "shprt/base/vec.h"
#include "shprt/coefficients/light_coefficients.h"

namespace shprt {

struct DominantLight {
  Vec3d direction;                          // unit, towards the light; zero when there is none
  std::array<double, 3> irradiance{};       // on a surface that faces it, per colour, never negative
  std::array<double, 3> ambientRadiance{};  // the same from everywhere, per colour, never negative
  std::array<double, 3> unexplained{};      // share in [0,1] of the irradiance's variation over normals that
                                            // neither explains
};

// The direction is that of band 1 of the luminance. For it, irradiance and ambientRadiance minimise, for each
// colour apart and among values that are not negative, the integral over normals of (E - E')^2, with E the
// irradiance under the light and E' that under both together, both to the light's degree. A directional light
// plus a constant comes back exactly, to rounding.
DominantLight dominantLight(const LightCoefficients& light);

}  // namespace shprt
