#include "shprt/study/probe_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "shprt/light/project_probe.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

double luminanceOfMagnitudes(Vec3d radiance) {
  return 0.2126 * std::fabs(radiance.x) + 0.7152 * std::fabs(radiance.y) + 0.0722 * std::fabs(radiance.z);
}

// What the pixels that can be used have to be multiplied with to stand for the whole sphere.
double scaleOf(const EnvironmentMap& map) {
  double solidAngle = 0;
  for (int y = 0; y < map.image.height; ++y)
    for (int x = 0; x < map.image.width; ++x)
      if (isFinite(map.image.at(x, y)))
        solidAngle += pixelFootprint(map.layout, map.image.width, map.image.height, x, y).solidAngle;
  return solidAngle > 0 ? 4 * std::numbers::pi / solidAngle : 0;
}

// For latitude-longitude pictures the pixels, for others cells of half a pixel's size.
int cellRows(const EnvironmentMap& map) {
  if (map.layout == EnvironmentLayout::kLatitudeLongitude) return map.image.height;
  return std::max(1, static_cast<int>(std::sqrt(static_cast<double>(map.image.pixels.size()))));
}
int cellColumns(const EnvironmentMap& map) {
  return map.layout == EnvironmentLayout::kLatitudeLongitude ? map.image.width : 2 * cellRows(map);
}

}  // namespace

ProbeSky::ProbeSky(const EnvironmentMap& map)
    : map_(map), scale_(scaleOf(map)), sampler_(cellRows(map), cellColumns(map), [this](Vec3d direction) {
        return luminanceOfMagnitudes(radiance(direction));
      }) {}

Vec3d ProbeSky::radiance(Vec3d direction) const {
  const Image& image = map_.image;
  const PixelPosition position = pixelPosition(map_.layout, image.width, image.height, direction);
  const auto indexOf = [](double x, int count) {
    return std::clamp(static_cast<int>(std::floor(x)), 0, count - 1);
  };
  const Vec3f pixel = image.at(indexOf(position.x, image.width), indexOf(position.y, image.height));
  return isFinite(pixel) ? toDouble(pixel) * scale_ : Vec3d{};
}

ExpandedSky::ExpandedSky(const LightCoefficients& light, int degree)
    : light_(withDegree(light, std::min({degree, light.degree, kMaximumBakeDegree}))),
      sampler_(4 * (light_.degree + 1), 8 * (light_.degree + 1),
               [this](Vec3d direction) { return luminanceOfMagnitudes(radiance(direction)); }) {}

Vec3d ExpandedSky::radiance(Vec3d direction) const {
  std::array<double, coefficientCount(kMaximumBakeDegree)> basis;
  evaluateSh(light_.degree, direction, basis);
  Vec3d sum;
  for (std::size_t i = 0; i < light_.coefficients.size(); ++i) {
    const std::array<double, 3>& c = light_.coefficients[i];
    sum += Vec3d{c[0], c[1], c[2]} * basis[i];
  }
  return sum;
}

}  // namespace shprt
