// The darkest surface under a light, and the darkest direction of the light itself.
#pragma once

#include "shprt/coefficients/light_coefficients.h"
#include "shprt/sh/basis.h"

namespace shprt {

// Degree to which the searches are meant to be used: their work grows with its fourth power.
inline constexpr int kMaximumSearchDegree = kMaximumBakeDegree;

// The least irradiance over all directions and colours, each colour relative to its average irradiance: 1 for
// light that comes evenly from everywhere, negative where the light rings. Colours whose average is not
// positive are left out.
double leastRelativeIrradiance(const LightCoefficients& light);

// The same of the radiance that the coefficients hold. Never above the least irradiance, which averages it
// over a hemisphere.
double leastRelativeRadiance(const LightCoefficients& light);

}  // namespace shprt
