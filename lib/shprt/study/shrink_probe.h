// A light probe of lower resolution, as a renderer with less memory would hold it.
#pragma once

#include "shprt/image/environment.h"

namespace shprt {

// Sides of the picture over `factor` (at least 1), rounded down, but whole cells of cube layouts and at least
// a pixel of each. A pixel is the mean of those that it covers, by the share of them that it covers and by
// their solid angles, so a constant stays what it is, and light keeps its power. Pixels that are not finite
// are left out; where there are no others, the result is not finite.
EnvironmentMap shrinkProbe(const EnvironmentMap& map, int factor);

}  // namespace shprt
