// Windows multiply band l by a factor between 0 and 1, with width w = degree + 1:
//   hann           (1 + cos(pi l / w)) / 2
//   lanczos        sin(pi l / w) / (pi l / w)
//   gaussian       exp(-(pi / 2w)^2 l (l+1)): diffusion on the sphere, for small angles a blur by a Gaussian
//   of
//                  standard deviation pi / (sqrt 2 w) rad. It begins as hann does but leaves some 7% at l =
//                  w.
//   auto           1 for l = 0 and f for all others: the light mixed with its own average. Irradiance is
//                  linear, so its least value, m averages, becomes 1 + f (m - 1), and f = 1 / (1 - m) is the
//                  largest factor that leaves none negative.
//   auto-radiance  the same with the least value of the radiance itself.
//
// Based on: Sloan 2008, "Stupid Spherical Harmonics (SH) Tricks", section on windowing (hann, lanczos). Its
// window for non-negative functions, 1 / (1 + lambda l^2 (l+1)^2), takes far more than is needed: for a sun
// alone, 86% of what bands 1 and 2 hold at degree 2 and 99.6% at degree 16, where auto takes 25% and 5%.

#include "shprt/light/window.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/light/irradiance_minimum.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

using std::numbers::pi;

// The search for the least value ends this close to it.
constexpr double kMargin = 1e-9;

template <typename BandFactor>
LightCoefficients scaleBands(const LightCoefficients& light, const BandFactor& factor) {
  LightCoefficients scaled = light;
  for (int l = 1; l <= light.degree; ++l)
    for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i)
      for (double& value : scaled.coefficients[static_cast<std::size_t>(i)]) value *= factor(l);
  return scaled;
}

// Mixed with its average by as little as brings `least`, relative to the average, up to zero.
LightCoefficients liftToZero(const LightCoefficients& light, double least) {
  if (least >= 0) return light;
  return scaleBands(light, [&](int) { return (1 - kMargin) / (1 - least); });
}

// Energy in bands 1 and up.
double directionalEnergy(const LightCoefficients& light) {
  double energy = 0;
  for (std::size_t i = 1; i < light.coefficients.size(); ++i)
    for (const double value : light.coefficients[i]) energy += value * value;
  return energy;
}

// Whether values can be relative to the averages: of every colour that has any light, and there is some.
bool hasPositiveAverages(const LightCoefficients& light) {
  bool any = false;
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const bool dark = std::all_of(light.coefficients.begin(), light.coefficients.end(),
                                  [&](const auto& coefficient) { return coefficient[colour] == 0; });
    if (!dark && !(light.coefficients[0][colour] > 0)) return false;
    any = any || !dark;
  }
  return any;
}

}  // namespace

Window parseWindow(const std::string& name) {
  if (name == "none") return Window::kNone;
  if (name == "hann") return Window::kHann;
  if (name == "lanczos") return Window::kLanczos;
  if (name == "gaussian") return Window::kGaussian;
  if (name == "auto") return Window::kAuto;
  if (name == "auto-radiance") return Window::kAutoRadiance;
  throw Error("window '" + name + "'", "is not known",
              "use one of none, hann, lanczos, gaussian, auto, auto-radiance");
}

WindowResult applyWindow(const LightCoefficients& light, Window window) {
  if ((window == Window::kAuto || window == Window::kAutoRadiance) && light.degree > kMaximumSearchDegree) {
    throw Error("automatic window", "degree " + std::to_string(light.degree) + " is beyond its search",
                "use degree " + std::to_string(kMaximumSearchDegree) + " or less, or another window");
  }
  const double width = light.degree + 1;
  WindowResult result{light, "none", 0, {}, {}};
  switch (window) {
    case Window::kNone:
      break;
    case Window::kHann:
      result.name = "hann";
      result.light = scaleBands(light, [&](int l) { return (1 + std::cos(pi * l / width)) / 2; });
      break;
    case Window::kLanczos:
      result.name = "lanczos";
      result.light = scaleBands(light, [&](int l) { return std::sin(pi * l / width) / (pi * l / width); });
      break;
    case Window::kGaussian: {
      const double slope = pi / (2 * width);
      result.name = "gaussian";
      result.light = scaleBands(light, [&](int l) { return std::exp(-slope * slope * l * (l + 1.0)); });
      break;
    }
    case Window::kAuto:
      result.name = "auto";
      result.light = liftToZero(light, leastRelativeIrradiance(light));
      break;
    case Window::kAutoRadiance:
      result.name = "auto-radiance";
      result.light = liftToZero(light, leastRelativeRadiance(light));
      break;
  }
  const double before = directionalEnergy(light);
  if (before > 0) result.strength = std::fmax(0.0, 1 - directionalEnergy(result.light) / before);
  if (light.degree <= kMaximumSearchDegree && hasPositiveAverages(light)) {
    result.minimumIrradiance = leastRelativeIrradiance(result.light);
    result.minimumRadiance = leastRelativeRadiance(result.light);
  }
  return result;
}

}  // namespace shprt
