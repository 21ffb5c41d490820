// What sampling leaves uncertain in relit radiance, from what it leaves uncertain in each band of the
// transfer. Rays are spread by the cosine, and where they err is not known; so a vertex's errors are taken
// for white noise over its cosine-weighted hemisphere, with every band scaled to its standard error. The
// variance of the radiance is then a mean over that hemisphere of the square of the light's bands, so scaled.
// Averaged over all turns of the light it is sum_l s_l^2 |L_l|^2 / (2l+1), whatever the errors' distribution
// (the orthogonality of the rotations' matrices).

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "shprt/base/parallel.h"
#include "shprt/relight/relight.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/gauss_legendre.h"
#include "shprt/sh/zonal.h"

namespace shprt {
namespace {

constexpr std::size_t kBlock = 256;

using Colours = std::array<double, 3>;

// The light's bands, over sqrt((2l+1)/4pi), in directions over the whole sphere.
struct BandTable {
  std::size_t bands = 0;
  std::vector<Vec3d> directions;
  std::vector<double> weights;  // steradians over pi
  std::vector<double> cosine;   // band factors
  std::vector<Colours> values;  // [direction][band]
};

// The square of the light is blind to the clamped cosine's bands beyond its own, twice the degree; with those
// the integrand is a polynomial, for which the rule is exact.
BandTable tabulateBands(int degree, const LightCoefficients& light) {
  BandTable table;
  table.bands = static_cast<std::size_t>(degree) + 1;
  const int rings = 2 * degree + 1, azimuths = 4 * degree + 1;
  table.cosine = clampedCosineFactors(2 * degree);
  const GaussLegendreRule rule = gaussLegendre(rings);
  std::vector<double> basis(static_cast<std::size_t>(coefficientCount(degree)));
  for (std::size_t ring = 0; ring < rule.nodes.size(); ++ring)
    for (int k = 0; k < azimuths; ++k) {
      const double z = rule.nodes[ring], r = std::sqrt(1 - z * z), phi = 2 * std::numbers::pi * k / azimuths;
      table.directions.push_back({r * std::cos(phi), r * std::sin(phi), z});
      table.weights.push_back(rule.weights[ring] * 2 / azimuths);
      evaluateSh(degree, table.directions.back(), basis);
      for (int l = 0; l <= degree; ++l) {
        const double scale = std::sqrt(4 * std::numbers::pi / (2 * l + 1));
        Colours sum = {};
        for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i)
          for (std::size_t colour = 0; colour < 3; ++colour) {
            sum[colour] += scale * basis[static_cast<std::size_t>(i)] *
                           light.coefficients[static_cast<std::size_t>(i)][colour];
          }
        table.values.push_back(sum);
      }
    }
  return table;
}

// standardErrors: [colour][band]
Colours radianceVariance(const BandTable& table, Vec3d normal, const std::vector<double>* standardErrors) {
  Colours sum = {};
  for (std::size_t d = 0; d < table.directions.size(); ++d) {
    const double cosTheta = std::clamp(dot(normal, table.directions[d]), -1.0, 1.0),
                 weight = evaluateZonal(table.cosine, cosTheta) * table.weights[d];
    const Colours* values = &table.values[d * table.bands];
    Colours noise = {};
    for (std::size_t l = 0; l < table.bands; ++l)
      for (std::size_t colour = 0; colour < 3; ++colour)
        noise[colour] += standardErrors[colour][l] * values[l][colour];
    for (std::size_t colour = 0; colour < 3; ++colour) sum[colour] += weight * noise[colour] * noise[colour];
  }
  // Some weights are negative, so that nothing may be less than that by rounding.
  for (double& value : sum) value = std::max(0.0, value);
  return sum;
}

Vec3d squares(const Vec3d& v) {
  return {v.x * v.x, v.y * v.y, v.z * v.z};
}

}  // namespace

std::vector<Vec3f> relightError(const TransferAsset& asset, const LightCoefficients& light,
                                double emissionScale) {
  const TransferError& error = asset.error;
  if (error.empty()) return {};
  assert(error.channels == 1 || error.channels == 3);
  assert(asset.normals.size() == error.vertexCount);
  assert(asset.emissionError.empty() || asset.emissionError.size() == error.vertexCount);
  const BandTable table = tabulateBands(std::min(error.degree, light.degree), light);
  std::vector<Vec3f> standardError(error.vertexCount);
  parallelForBlocks(error.vertexCount, kBlock, [&](std::size_t begin, std::size_t end) {
    std::vector<double> ofVertex[3];
    for (std::vector<double>& bands : ofVertex) bands.resize(table.bands);
    for (std::size_t v = begin; v < end; ++v) {
      for (int colour = 0; colour < 3; ++colour)
        for (std::size_t l = 0; l < table.bands; ++l)
          ofVertex[colour][l] = error.row(error.channels == 1 ? 0 : colour, static_cast<int>(l))[v];
      const Colours own = radianceVariance(table, toDouble(asset.normals[v]), ofVertex);
      Vec3d variance{own[0], own[1], own[2]};
      if (!asset.emissionError.empty()) variance += squares(toDouble(asset.emissionError[v]) * emissionScale);
      standardError[v] = toFloat({std::sqrt(variance.x), std::sqrt(variance.y), std::sqrt(variance.z)});
    }
  });
  return standardError;
}

}  // namespace shprt
