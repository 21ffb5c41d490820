// Directional and constant lights in closed form, and what can be done to a light's coefficients. What its
// maker measured describes the light as it was made, so changed lights carry no statistics.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "shprt/base/error.h"
#include "shprt/light/project_probe.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"

namespace shprt {

LightCoefficients projectDirectional(Vec3d direction, const std::array<double, 3>& irradiance, int degree) {
  const Vec3d unit = isFinite(direction) ? normalize(direction) : Vec3d{};
  if (unit == Vec3d{})
    throw Error("directional light", "has no direction", "give a nonzero vector towards the light");
  std::vector<double> basis(static_cast<std::size_t>(coefficientCount(degree)));
  evaluateSh(degree, unit, basis);
  LightCoefficients light;
  light.degree = degree;
  for (const double y : basis)
    light.coefficients.push_back({irradiance[0] * y, irradiance[1] * y, irradiance[2] * y});
  light.source = "directional";
  return light;
}

LightCoefficients projectConstant(const std::array<double, 3>& radiance, int degree) {
  LightCoefficients light;
  light.degree = degree;
  light.coefficients.resize(static_cast<std::size_t>(coefficientCount(degree)));
  for (std::size_t c = 0; c < 3; ++c)
    light.coefficients[0][c] = radiance[c] * std::sqrt(4 * std::numbers::pi);
  light.source = "constant";
  return light;
}

LightCoefficients addLights(const LightCoefficients& a, const LightCoefficients& b) {
  LightCoefficients sum = withDegree(a, std::min(a.degree, b.degree));
  sum.statisticsJson.clear();
  for (std::size_t i = 0; i < sum.coefficients.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) sum.coefficients[i][c] += b.coefficients[i][c];
  sum.source = a.source.empty() ? b.source : b.source.empty() ? a.source : a.source + " + " + b.source;
  return sum;
}

LightCoefficients withDegree(const LightCoefficients& light, int degree) {
  if (degree == light.degree) return light;
  LightCoefficients changed = light;
  changed.degree = degree;
  changed.coefficients.resize(static_cast<std::size_t>(coefficientCount(degree)));
  changed.statisticsJson.clear();
  return changed;
}

LightCoefficients rotateLight(const LightCoefficients& light, const Mat3& rotation) {
  std::array<std::vector<double>, 3> colours;
  for (std::size_t c = 0; c < 3; ++c)
    for (const auto& coefficient : light.coefficients) colours[c].push_back(coefficient[c]);
  const std::span<double> sets[] = {colours[0], colours[1], colours[2]};
  ShRotation(light.degree, rotation).apply(sets);
  LightCoefficients rotated = light;
  for (std::size_t i = 0; i < rotated.coefficients.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) rotated.coefficients[i][c] = colours[c][i];
  rotated.statisticsJson.clear();
  return rotated;
}

LightCoefficients scaleLight(const LightCoefficients& light, double factor) {
  LightCoefficients scaled = light;
  for (auto& coefficient : scaled.coefficients)
    for (double& value : coefficient) value *= factor;
  scaled.statisticsJson.clear();
  return scaled;
}

}  // namespace shprt
