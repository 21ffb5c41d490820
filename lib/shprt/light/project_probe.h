// Light probes and simple analytic lights to SH coefficients of their radiance.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/coefficients/light_coefficients.h"
#include "shprt/image/environment.h"

namespace shprt {

struct ProbeProjection {
  LightCoefficients light;
  std::uint64_t pixels = 0;  // that show a direction
  std::uint64_t nonFinitePixels =
      0;  // NaN or infinite in any channel: left out, the rest stands for their solid angle
  std::uint64_t negativePixels = 0;  // negative in any channel: used as they are, or clamped to 0 when asked
  double solidAngle = 0;             // of the pixels used, steradian; 4 pi when all are
  std::array<double, 3> energy{};    // integral of radiance^2 over the sphere
  std::array<double, 3> energyMissed{};  // share of it in [0,1] that the degree does not hold
};

struct ProjectOptions {
  int degree = 4;
  bool clampNegative =
      false;  // Negative pixels come from sharpening filters that overshoot; kept, they cancel the overshoot.
  bool strict = false;  // refuse (Error) NaN, infinite and negative pixels
};

ProbeProjection projectProbe(const EnvironmentMap& map, const ProjectOptions& options);

// irradiance * y_lm(direction): direction points towards the light (any length), irradiance on a surface
// facing it.
LightCoefficients projectDirectional(Vec3d direction, const std::array<double, 3>& irradiance, int degree);
// The same radiance from everywhere.
LightCoefficients projectConstant(const std::array<double, 3>& radiance, int degree);

// Adds b to a; the sum has the lower degree of the two.
LightCoefficients addLights(const LightCoefficients& a, const LightCoefficients& b);
// Drops bands above degree, or pads with zeros.
LightCoefficients withDegree(const LightCoefficients& light, int degree);
LightCoefficients rotateLight(const LightCoefficients& light, const Mat3& rotation);
LightCoefficients scaleLight(const LightCoefficients& light, double factor);

}  // namespace shprt
