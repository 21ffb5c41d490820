// Probe images to coefficients: sums over pixels of radiance times basis times solid angle.
//
// A latitude-longitude picture is separable about its own pole (+Y): each row is first summed against cos and
// sin of multiples of the longitude, and only these few sums meet the Legendre functions of the row. The
// result is then turned so that the pole lies along +Z, the axis of the basis. Other layouts evaluate the
// basis at every pixel. Based on: Ramamoorthi and Hanrahan 2001, eq. 10 (projection); Driscoll and Healy 1994
// (separation of variables).

#include "shprt/light/project_probe.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "shprt/base/error.h"
#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"

namespace shprt {
namespace {

using std::numbers::pi;
using Coefficients = std::vector<std::array<double, 3>>;

// What a block of rows adds; blocks are summed in order, so the result does not depend on threads.
struct PartialSum {
  Coefficients coefficients;
  std::uint64_t pixels = 0, nonFinite = 0, negative = 0;
  double solidAngle = 0;
  std::array<double, 3> energy{};
};

// Counts and mends one pixel.
bool usePixel(const Vec3f& pixel, double solidAngle, bool clampNegative, std::array<double, 3>& radiance,
              PartialSum& sum) {
  ++sum.pixels;
  if (!isFinite(pixel)) {
    ++sum.nonFinite;
    return false;
  }
  radiance = {static_cast<double>(pixel.x), static_cast<double>(pixel.y), static_cast<double>(pixel.z)};
  if (radiance[0] < 0 || radiance[1] < 0 || radiance[2] < 0) {
    ++sum.negative;
    if (clampNegative) {
      for (double& value : radiance) value = std::max(value, 0.0);
    }
  }
  sum.solidAngle += solidAngle;
  for (std::size_t c = 0; c < 3; ++c) sum.energy[c] += solidAngle * radiance[c] * radiance[c];
  return true;
}

// cos and sin of m times the longitude of each column of the left half; the right half mirrors them.
class LongitudeTables {
 public:
  LongitudeTables(int degree, int width) : half_(static_cast<std::size_t>(width + 1) / 2) {
    cosines_.resize(static_cast<std::size_t>(degree + 1) * half_);
    sines_.resize(cosines_.size());
    for (int m = 0; m <= degree; ++m)
      for (std::size_t x = 0; x < half_; ++x) {
        const double phi = pi * (1 - 2 * (static_cast<double>(x) + 0.5) / width);
        cosines_[static_cast<std::size_t>(m) * half_ + x] = std::cos(m * phi);
        sines_[static_cast<std::size_t>(m) * half_ + x] = std::sin(m * phi);
      }
  }
  std::size_t half() const { return half_; }
  const double* cosines(int m) const { return &cosines_[static_cast<std::size_t>(m) * half_]; }
  const double* sines(int m) const { return &sines_[static_cast<std::size_t>(m) * half_]; }

 private:
  std::size_t half_;
  std::vector<double> cosines_, sines_;
};

double dotProduct(const double* a, const double* b, std::size_t count) {
  // Four partial sums let the additions overlap; their order is fixed.
  double sums[4] = {};
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4)
    for (std::size_t k = 0; k < 4; ++k) sums[k] += a[i + k] * b[i + k];
  for (; i < count; ++i) sums[0] += a[i] * b[i];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

// Coefficients about the picture's own pole: local z is +Y, local x is +Z, local y is +X.
void addLatitudeRow(const Image& image, int y, const ProjectOptions& options, const LongitudeTables& tables,
                    PartialSum& sum) {
  const int degree = options.degree;
  const int width = image.width;
  const std::size_t half = tables.half();
  const double solidAngle =
      pixelFootprint(EnvironmentLayout::kLatitudeLongitude, width, image.height, 0, y).solidAngle;
  std::vector<double> even[3], odd[3];
  for (int c = 0; c < 3; ++c) even[c].assign(half, 0.0), odd[c].assign(half, 0.0);
  for (int x = 0; x < width; ++x) {
    std::array<double, 3> radiance;
    if (!usePixel(image.at(x, y), solidAngle, options.clampNegative, radiance, sum)) continue;
    const bool mirrored = x >= static_cast<int>(half);
    const auto column = static_cast<std::size_t>(mirrored ? width - 1 - x : x);
    for (std::size_t c = 0; c < 3; ++c) {
      even[c][column] += radiance[c];
      odd[c][column] += mirrored ? -radiance[c] : radiance[c];
    }
  }
  const double theta = pi * (y + 0.5) / image.height;
  std::vector<double> basis(static_cast<std::size_t>(coefficientCount(degree)));
  evaluateSh(degree, {std::sin(theta), 0, std::cos(theta)}, basis);
  for (int m = 0; m <= degree; ++m)
    for (std::size_t c = 0; c < 3; ++c) {
      const double cosine = solidAngle * dotProduct(even[c].data(), tables.cosines(m), half);
      const double sine = m > 0 ? solidAngle * dotProduct(odd[c].data(), tables.sines(m), half) : 0;
      for (int l = m; l <= degree; ++l) {
        const double legendre = basis[static_cast<std::size_t>(shIndex(l, m))];
        sum.coefficients[static_cast<std::size_t>(shIndex(l, m))][c] += legendre * cosine;
        if (m > 0) sum.coefficients[static_cast<std::size_t>(shIndex(l, -m))][c] += legendre * sine;
      }
    }
}

void addRow(const EnvironmentMap& map, int y, const ProjectOptions& options, PartialSum& sum) {
  std::vector<double> basis(static_cast<std::size_t>(coefficientCount(options.degree)));
  for (int x = 0; x < map.image.width; ++x) {
    const PixelFootprint footprint = pixelFootprint(map.layout, map.image.width, map.image.height, x, y);
    std::array<double, 3> radiance;
    if (footprint.solidAngle <= 0 ||
        !usePixel(map.image.at(x, y), footprint.solidAngle, options.clampNegative, radiance, sum))
      continue;
    evaluateSh(options.degree, footprint.direction, basis);
    for (std::size_t i = 0; i < basis.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        sum.coefficients[i][c] += footprint.solidAngle * basis[i] * radiance[c];
  }
}

void add(PartialSum& total, const PartialSum& part) {
  for (std::size_t i = 0; i < total.coefficients.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) total.coefficients[i][c] += part.coefficients[i][c];
  total.pixels += part.pixels;
  total.nonFinite += part.nonFinite;
  total.negative += part.negative;
  total.solidAngle += part.solidAngle;
  for (std::size_t c = 0; c < 3; ++c) total.energy[c] += part.energy[c];
}

std::string nameOf(const EnvironmentMap& map) {
  return map.sources.empty() ? "probe" : map.sources.front().string();
}

}  // namespace

ProbeProjection projectProbe(const EnvironmentMap& map, const ProjectOptions& options) {
  const bool separable = map.layout == EnvironmentLayout::kLatitudeLongitude;
  const LongitudeTables tables(separable ? options.degree : 0, separable ? map.image.width : 1);
  constexpr std::size_t kRowsPerBlock = 8;
  const auto rows = static_cast<std::size_t>(map.image.height);
  std::vector<PartialSum> parts((rows + kRowsPerBlock - 1) / kRowsPerBlock);
  const auto coefficients = static_cast<std::size_t>(coefficientCount(options.degree));
  parallelForBlocks(rows, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
    PartialSum& part = parts[begin / kRowsPerBlock];
    part.coefficients.resize(coefficients);
    for (std::size_t y = begin; y < end; ++y) {
      if (separable)
        addLatitudeRow(map.image, static_cast<int>(y), options, tables, part);
      else
        addRow(map, static_cast<int>(y), options, part);
    }
  });
  PartialSum total;
  total.coefficients.resize(coefficients);
  for (const PartialSum& part : parts) add(total, part);

  if (options.strict && total.nonFinite + total.negative > 0) {
    throw Error(nameOf(map),
                std::to_string(total.nonFinite) + " pixels are not finite and " +
                    std::to_string(total.negative) + " negative",
                "mend them, or leave out --strict");
  }
  if (!(total.solidAngle > 0))
    throw Error(nameOf(map), "has no usable pixel", "give an image with finite values");
  // Pixels that were left out are stood for by the rest.
  const double scale = 4 * pi / total.solidAngle;
  ProbeProjection projection;
  projection.light.degree = options.degree;
  projection.light.coefficients = std::move(total.coefficients);
  for (auto& coefficient : projection.light.coefficients)
    for (double& value : coefficient) value *= scale;
  if (separable) {
    // The local frame's axes are (+Z, +X, +Y).
    projection.light = rotateLight(projection.light, {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}});
  }
  projection.light.source = nameOf(map) + " (" + layoutName(map.layout) + ")";
  projection.pixels = total.pixels;
  projection.nonFinitePixels = total.nonFinite;
  projection.negativePixels = total.negative;
  projection.solidAngle = total.solidAngle;
  for (std::size_t c = 0; c < 3; ++c) {
    projection.energy[c] = total.energy[c] * scale;
    double held = 0;
    for (const auto& coefficient : projection.light.coefficients) held += coefficient[c] * coefficient[c];
    if (projection.energy[c] > 0)
      projection.energyMissed[c] = std::clamp(1 - held / projection.energy[c], 0.0, 1.0);
  }
  return projection;
}

LightCoefficients projectDirectional(Vec3d direction, const std::array<double, 3>& irradiance, int degree) {
  const Vec3d unit = normalize(direction);
  if (unit == Vec3d{} || !isFinite(unit))
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
  for (std::size_t c = 0; c < 3; ++c) light.coefficients[0][c] = radiance[c] * std::sqrt(4 * pi);
  light.source = "constant";
  return light;
}

LightCoefficients addLights(const LightCoefficients& a, const LightCoefficients& b) {
  LightCoefficients sum = withDegree(a, std::min(a.degree, b.degree));
  for (std::size_t i = 0; i < sum.coefficients.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) sum.coefficients[i][c] += b.coefficients[i][c];
  sum.source = a.source.empty() ? b.source : b.source.empty() ? a.source : a.source + " + " + b.source;
  sum.statisticsJson.clear();
  return sum;
}

LightCoefficients withDegree(const LightCoefficients& light, int degree) {
  LightCoefficients changed = light;
  changed.degree = degree;
  changed.coefficients.resize(static_cast<std::size_t>(coefficientCount(degree)));
  return changed;
}

LightCoefficients rotateLight(const LightCoefficients& light, const Mat3& rotation) {
  std::vector<double> colours[3];
  for (std::size_t c = 0; c < 3; ++c)
    for (const auto& coefficient : light.coefficients) colours[c].push_back(coefficient[c]);
  const std::span<double> sets[] = {colours[0], colours[1], colours[2]};
  ShRotation(light.degree, rotation).apply(sets);
  LightCoefficients rotated = light;
  for (std::size_t i = 0; i < rotated.coefficients.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) rotated.coefficients[i][c] = colours[c][i];
  return rotated;
}

LightCoefficients scaleLight(const LightCoefficients& light, double factor) {
  LightCoefficients scaled = light;
  for (auto& coefficient : scaled.coefficients)
    for (double& value : coefficient) value *= factor;
  return scaled;
}

}  // namespace shprt
