// With A_l the factors of the clamped cosine, d the direction, e its irradiance and a the ambient radiance,
// the error is the sum over l, m of A_l^2 (L_lm - e y_lm(d) - [l = 0] a sqrt(4 pi))^2. Only a reaches into
// band 0 alone, so without bounds e is the least-squares fit to bands 1 and up, and a takes what that leaves
// of band 0. Where a would be negative it is 0 and e is the fit to all bands; where e would be, it is 0: the
// error is convex, so the constrained minimum lies on the side that the free one violates. Based on: Sloan
// 2008, sections on extracting a dominant light; there radiance is fitted, here irradiance, which diffuse
// shading shows.

#include "shprt/light/dominant_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shprt/sh/basis.h"
#include "shprt/sh/zonal.h"

namespace shprt {
namespace {

const double kAmbient = std::sqrt(4 * std::numbers::pi);  // band 0 of radiance 1 from everywhere

// Sums over bands 1 and up, weighted by A_l^2: of L y(d), of y(d)^2, of L^2.
struct Products {
  double mixed = 0, unit = 0, light = 0;
};

Products sumProducts(const LightCoefficients& light, std::size_t colour, const std::vector<double>& basis,
                     const std::vector<double>& cosine) {
  Products sums;
  for (int l = 1; l <= light.degree; ++l) {
    const double weight = cosine[static_cast<std::size_t>(l)] * cosine[static_cast<std::size_t>(l)];
    for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i) {
      const double value = light.coefficients[static_cast<std::size_t>(i)][colour],
                   unit = basis[static_cast<std::size_t>(i)];
      sums.mixed += weight * value * unit;
      sums.unit += weight * unit * unit;
      sums.light += weight * value * value;
    }
  }
  return sums;
}

}  // namespace

DominantLight dominantLight(const LightCoefficients& light) {
  DominantLight dominant;
  const std::array<double, 3> direction = measureLight(light).dominantDirection;
  dominant.direction = {direction[0], direction[1], direction[2]};
  const bool directed = dominant.direction != Vec3d{};
  std::vector<double> basis(light.coefficients.size(), 0.0);  // of no direction, nothing
  if (directed) evaluateSh(light.degree, dominant.direction, basis);
  const std::vector<double> cosine = clampedCosineFactors(light.degree);
  for (std::size_t c = 0; c < 3; ++c) {
    const Products sums = sumProducts(light, c, basis, cosine);
    const double band0 = light.coefficients[0][c], unit0 = basis[0], weight0 = cosine[0] * cosine[0];
    double irradiance = directed ? std::max(0.0, sums.mixed / sums.unit) : 0;
    double ambient = (band0 - irradiance * unit0) / kAmbient;
    if (ambient < 0) {
      ambient = 0;
      if (irradiance > 0) {
        irradiance = (weight0 * band0 * unit0 + sums.mixed) / (weight0 * unit0 * unit0 + sums.unit);
        irradiance = std::max(0.0, irradiance);
      }
    }
    dominant.irradiance[c] = irradiance;
    dominant.ambientRadiance[c] = ambient;
    const double rest = sums.light + irradiance * (irradiance * sums.unit - 2 * sums.mixed);
    dominant.unexplained[c] = sums.light > 0 ? std::clamp(rest / sums.light, 0.0, 1.0) : 0;
  }
  return dominant;
}

}  // namespace shprt
