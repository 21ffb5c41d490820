// The darkest surface under a light.
#pragma once

#include "shprt/coefficients/light_coefficients.h"

namespace shprt {

// The least irradiance over all directions and colours, each colour relative to its average irradiance: 1 for
// light that comes evenly from everywhere, negative where the light rings. Colours whose average is not
// positive are left out.
double leastRelativeIrradiance(const LightCoefficients& light);

}  // namespace shprt
