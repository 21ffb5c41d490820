// What the rays of each point leave uncertain, from the differences between parts of them.
//
// A point's rays come in quarters (HemisphereSet). With Q the estimate of all rays and Qi that of a quarter,
// the mean over i of E|Qi - Q|^2 is V2 - V0, where V0 is the variance of the whole and V2 that of a quarter:
// an identity, whatever their correlation. Evenly spread points gain a ratio r = V2/V0 from four times the
// rays, 4 if they were independent and more the evener they are, so that V0 = (V2-V0) / (r-1). Sixteenths
// tell r: over many points, (V4-V2)/(V2-V0), with V4 the variance of one of them. Only r is taken from a
// coarser scale; nothing else is assumed.
//
// Because every vertex has its own random shift, sums over vertices have many independent terms, and come out
// sharp where the differences at one vertex do not. The vertices' number of rays must not have been chosen by
// looking at these same rays: who stops where differences happen to be small would believe them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/transfer/light_rows.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

// Columns of one point's errors: per channel of transfer one for each band l, then three for light of the
// scene's own where it emits.
struct ErrorLayout {
  int channels = 1, degree = 0;
  bool emission = false;

  std::size_t column(int channel, int band) const {
    return static_cast<std::size_t>(channel * (degree + 1) + band);
  }
  std::size_t emissionColumn() const { return column(channels, 0); }
  std::size_t columns() const { return emissionColumn() + (emission ? 3u : 0u); }
};

inline constexpr std::size_t kRateStride = 8;

// Per unit albedo, for all points of a scene.
struct PointErrors {
  PointErrors() = default;
  PointErrors(std::size_t points, const ErrorLayout& errorLayout)
      : layout(errorLayout),
        squares(points, errorLayout.columns()),
        rays(points),
        quarters(points),
        sixteenths(points) {}

  ErrorLayout layout;
  // Mean of |Qi - Q|^2 of each column; after toVariances (sampling_error.h) the variance that it tells.
  LightRows squares{0, 1};
  std::vector<std::uint32_t> rays;  // 0: exact without
  // Of shadowed transfer alone, at every kRateStride-th point (0 at others): that over all bands, and the
  // same of sixteenths and their quarters.
  std::vector<float> quarters, sixteenths;
};

// Four quarters' estimates as three contrasts, whose squares add up to the mean of (Qi - Q)^2.
constexpr std::array<double, 3> contrastsOf(double a, double b, double c, double d) {
  return {(a + b - c - d) / 4, (a - b + c - d) / 4, (a - b - c + d) / 4};
}

// Adds the squares of one contrast of a point: it holds the coefficients of each channel, and its three
// numbers of emission.
void addSquares(std::span<const double> contrast, std::size_t point, PointErrors& errors);

// Writes what one point's rays of shadowed transfer tell of the ratio between numbers of rays.
void storeRate(const std::array<std::span<const double>, 3>& contrasts, double sixteenthSquare,
               std::size_t point, PointErrors& errors);

}  // namespace shprt
