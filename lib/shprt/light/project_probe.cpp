// Probe images to coefficients: sums over pixels of radiance times basis times solid angle.
// Latitude-longitude pictures separate (latitude_sums.h) about their own pole, +Y, and their coefficients are
// then turned so that the pole lies along +Z, the axis of the basis. Other layouts evaluate the basis at
// every pixel; balls weigh their pixels (ball_weights.h). Based on: Ramamoorthi and Hanrahan 2001, eq. 10.

#include "shprt/light/project_probe.h"

#include <algorithm>
#include <numbers>
#include <optional>

#include "shprt/base/error.h"
#include "shprt/base/parallel.h"
#include "shprt/light/ball_weights.h"
#include "shprt/light/latitude_sums.h"
#include "shprt/light/probe_sums.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

using std::numbers::pi;

// Sums over blocks of rows, in parallel; addRows(begin, end, sums) adds some.
template <typename AddRows>
ProbeSums sumBlocks(int height, std::size_t coefficients, const AddRows& addRows) {
  constexpr std::size_t kRowsPerBlock = 8;
  const auto rows = static_cast<std::size_t>(height);
  std::vector<ProbeSums> blocks((rows + kRowsPerBlock - 1) / kRowsPerBlock, ProbeSums(coefficients));
  parallelForBlocks(rows, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
    addRows(static_cast<int>(begin), static_cast<int>(end), blocks[begin / kRowsPerBlock]);
  });
  ProbeSums total(coefficients);
  for (const ProbeSums& block : blocks) total.add(block);
  return total;
}

void addPixels(const EnvironmentMap& map, int y, const ProjectOptions& options,
               const std::optional<BallWeights>& weights, std::vector<double>& basis, ProbeSums& sums) {
  for (int x = 0; x < map.image.width; ++x) {
    const auto [direction, solidAngle] = pixelFootprint(map.layout, map.image.width, map.image.height, x, y);
    std::array<double, 3> radiance;
    if (solidAngle <= 0 || !mendPixel(map.image.at(x, y), options.clampNegative, radiance, sums)) continue;
    const double weight = weights ? solidAngle * weights->factor(direction.z) : solidAngle;
    sums.solidAngle += solidAngle;
    sums.weight += weight;
    for (std::size_t c = 0; c < 3; ++c) sums.energy[c] += weight * radiance[c] * radiance[c];
    evaluateSh(options.degree, direction, basis);
    for (std::size_t i = 0; i < basis.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) sums.coefficients[i][c] += weight * basis[i] * radiance[c];
  }
}

ProbeSums sumPixels(const EnvironmentMap& map, const ProjectOptions& options) {
  const auto count = static_cast<std::size_t>(coefficientCount(options.degree));
  const auto [width, height] = std::pair(map.image.width, map.image.height);
  if (map.layout == EnvironmentLayout::kLatitudeLongitude) {
    const LatitudeSums latitudes(options.degree, width);
    return sumBlocks(height, count, [&](int begin, int end, ProbeSums& sums) {
      latitudes.addRows(map.image, begin, end, options.clampNegative, sums);
    });
  }
  std::optional<BallWeights> weights;
  if (map.layout == EnvironmentLayout::kAngularMap || map.layout == EnvironmentLayout::kMirroredBall)
    weights.emplace(map.layout, width, height, 2 * options.degree);
  return sumBlocks(height, count, [&](int begin, int end, ProbeSums& sums) {
    std::vector<double> basis(count);
    for (int y = begin; y < end; ++y) addPixels(map, y, options, weights, basis, sums);
  });
}

std::string nameOf(const EnvironmentMap& map) {
  return map.sources.empty() ? "probe" : map.sources.front().string();
}

}  // namespace

ProbeProjection projectProbe(const EnvironmentMap& map, const ProjectOptions& options) {
  ProbeSums sums = sumPixels(map, options);
  if (options.strict && sums.nonFinite + sums.negative > 0) {
    throw Error(nameOf(map),
                std::to_string(sums.nonFinite) + " pixels are not finite and " +
                    std::to_string(sums.negative) + " negative",
                "mend them, or leave out --strict");
  }
  if (!(sums.weight > 0)) throw Error(nameOf(map), "has no usable pixel", "give an image with finite values");

  ProbeProjection projection;
  projection.pixels = sums.pixels;
  projection.nonFinitePixels = sums.nonFinite;
  projection.negativePixels = sums.negative;
  projection.solidAngle = sums.solidAngle;
  // Pixels that were left out are stood for by the rest.
  const double scale = 4 * pi / sums.weight;
  projection.light.degree = options.degree;
  projection.light.coefficients = std::move(sums.coefficients);
  for (auto& coefficient : projection.light.coefficients)
    for (double& value : coefficient) value *= scale;
  if (map.layout == EnvironmentLayout::kLatitudeLongitude) {
    // The local frame's axes are (+Z, +X, +Y).
    projection.light = rotateLight(projection.light, {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}});
  }
  projection.light.source = nameOf(map) + " (" + layoutName(map.layout) + ")";
  for (std::size_t c = 0; c < 3; ++c) {
    projection.energy[c] = sums.energy[c] * scale;
    double held = 0;
    for (const auto& coefficient : projection.light.coefficients) held += coefficient[c] * coefficient[c];
    if (projection.energy[c] > 0)
      projection.energyMissed[c] = std::clamp(1 - held / projection.energy[c], 0.0, 1.0);
  }
  return projection;
}

}  // namespace shprt
