// Windowing of light coefficients, against the ringing and negative lobes of high-contrast probes.
#pragma once

#include <optional>
#include <string>

#include "shprt/coefficients/light_coefficients.h"

namespace shprt {

enum class Window { kNone, kHann, kLanczos, kGaussian, kAuto, kAutoRadiance };
// none, hann, lanczos, gaussian, auto, auto-radiance; throws Error listing them
Window parseWindow(const std::string& name);

struct WindowResult {
  LightCoefficients light;
  std::string name;     // what was applied
  double strength = 0;  // share of the energy in bands 1 and up that was taken away, in [0,1]
  // Over the sphere, least channel, after windowing, relative to the average irradiance and radiance; none
  // above kMaximumSearchDegree, where they are not searched for, and where a colour has light but no positive
  // average.
  std::optional<double> minimumIrradiance, minimumRadiance;
};

// kAuto applies the least windowing (the light mixed with its own average, see window.cpp) for which the
// irradiance, the light convolved with the clamped cosine, is non-negative in every direction and channel;
// kAutoRadiance that for which the radiance itself is, which takes more. Both as found on a grid of six
// points per degree and by descent from its local minima (irradiance_minimum.cpp states the bound). A channel
// whose average is not positive is left out. Throws Error when either is asked for above
// kMaximumSearchDegree.
WindowResult applyWindow(const LightCoefficients& light, Window window);

}  // namespace shprt
