// Windows multiply band l by a factor between 0 and 1, with width w = degree + 1:
//   hann     (1 + cos(pi l / w)) / 2
//   lanczos  sin(pi l / w) / (pi l / w)
//   auto     1 / (1 + lambda l^2 (l+1)^2), the minimiser of squared error plus lambda times the squared
//   Laplacian, with the
//            least lambda for which the irradiance is nowhere negative.
// Based on: Sloan 2008, "Stupid Spherical Harmonics (SH) Tricks", section on windowing (hann, lanczos,
// Laplacian).

#include "shprt/light/window.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/base/vec.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/zonal.h"

namespace shprt {
namespace {

using std::numbers::pi;

LightCoefficients scaleBands(const LightCoefficients& light, const std::function<double(int)>& factor) {
  LightCoefficients scaled = light;
  for (int l = 0; l <= light.degree; ++l) {
    const double f = factor(l);
    for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i)
      for (double& value : scaled.coefficients[static_cast<std::size_t>(i)]) value *= f;
  }
  return scaled;
}

double laplacianFactor(int l, double lambda) {
  const double laplacian = static_cast<double>(l) * (l + 1);
  return 1 / (1 + lambda * laplacian * laplacian);
}

// The irradiance of a light relative to its average, as a function of direction and lambda. Per grid
// direction the bands are summed once, so that trying another lambda costs a few operations.
class Irradiance {
 public:
  explicit Irradiance(const LightCoefficients& light)
      : light_(light), cosine_(clampedCosineFactors(light.degree)) {
    // Finer than the shortest wave: 6 points per degree along a meridian.
    const int rows = 6 * (light.degree + 2), columns = 2 * rows;
    for (int i = 0; i <= rows; ++i)
      for (int j = 0; j < (i == 0 || i == rows ? 1 : columns); ++j) {
        const double theta = pi * i / rows, phi = 2 * pi * j / columns;
        const Vec3d direction{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                              std::cos(theta)};
        for (std::size_t colour = 0; colour < 3; ++colour) {
          if (light.coefficients[0][colour] > 0)
            points_.push_back({direction, colour, bandSums(direction, colour)});
        }
      }
    step_ = pi / rows;
  }

  // The least over all directions and colours. refined: the lowest grid points are followed downhill to their
  // minimum.
  double minimum(double lambda, bool refined) const {
    double least = 1;
    std::vector<std::pair<double, const Point*>> values;
    for (const Point& point : points_) {
      const double value = weigh(point.bands, lambda);
      least = std::min(least, value);
      if (refined) values.emplace_back(value, &point);
    }
    if (!refined) return least;
    const std::size_t followed = std::min<std::size_t>(24, values.size());
    std::partial_sort(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(followed), values.end(),
                      [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < followed; ++k)
      least = std::min(least, descend(*values[k].second, values[k].first, lambda));
    return least;
  }

 private:
  struct Point {
    Vec3d direction;
    std::size_t colour;
    std::vector<double> bands;
  };

  std::vector<double> bandSums(Vec3d direction, std::size_t colour) const {
    std::vector<double> basis(static_cast<std::size_t>(coefficientCount(light_.degree))), bands;
    evaluateSh(light_.degree, direction, basis);
    const double average = cosine_[0] * light_.coefficients[0][colour] * basis[0];
    for (int l = 0; l <= light_.degree; ++l) {
      double sum = 0;
      for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i)
        sum += light_.coefficients[static_cast<std::size_t>(i)][colour] * basis[static_cast<std::size_t>(i)];
      bands.push_back(cosine_[static_cast<std::size_t>(l)] * sum / average);
    }
    return bands;
  }

  static double weigh(const std::vector<double>& bands, double lambda) {
    double sum = 0;
    for (std::size_t l = 0; l < bands.size(); ++l)
      sum += laplacianFactor(static_cast<int>(l), lambda) * bands[l];
    return sum;
  }

  // Pattern search: tries four neighbours at a step that halves when none is lower.
  double descend(const Point& start, double value, double lambda) const {
    Vec3d here = start.direction;
    for (double step = step_ / 2; step > 1e-5;) {
      const Vec3d side = normalize(cross(here, std::abs(here.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0})),
                  up = cross(side, here);
      bool lower = false;
      for (const Vec3d offset : {side, -side, up, -up}) {
        const Vec3d there = normalize(here + offset * step);
        const double candidate = weigh(bandSums(there, start.colour), lambda);
        if (!(candidate < value)) continue;
        value = candidate;
        here = there;
        lower = true;
        break;
      }
      if (!lower) step /= 2;
    }
    return value;
  }

  const LightCoefficients& light_;
  std::vector<double> cosine_;
  std::vector<Point> points_;
  double step_ = 0;
};

double directionalEnergy(const LightCoefficients& light) {
  double energy = 0;
  for (std::size_t i = 1; i < light.coefficients.size(); ++i)
    for (const double value : light.coefficients[i]) energy += value * value;
  return energy;
}

double leastLambda(const Irradiance& irradiance) {
  if (irradiance.minimum(0, true) >= 0) return 0;
  double high = 1e-6;
  // Ends: at infinity only the average is left.
  while (irradiance.minimum(high, false) < 0) high *= 4;
  double low = high / 4;
  for (int step = 0; step < 40; ++step) {
    const double middle = std::sqrt(low * high);
    (irradiance.minimum(middle, false) < 0 ? low : high) = middle;
  }
  // Between grid points the irradiance may dip a little lower.
  while (irradiance.minimum(high, true) < 0) high *= 1.01;
  return high;
}

}  // namespace

Window parseWindow(const std::string& name) {
  if (name == "none") return Window::kNone;
  if (name == "hann") return Window::kHann;
  if (name == "lanczos") return Window::kLanczos;
  if (name == "auto") return Window::kAuto;
  throw Error("window '" + name + "'", "is not known", "use one of none, hann, lanczos, auto");
}

WindowResult applyWindow(const LightCoefficients& light, Window window) {
  const double width = light.degree + 1;
  WindowResult result{light, "none", 0, 0};
  switch (window) {
    case Window::kNone:
      break;
    case Window::kHann:
      result.name = "hann";
      result.light = scaleBands(light, [&](int l) { return (1 + std::cos(pi * l / width)) / 2; });
      break;
    case Window::kLanczos:
      result.name = "lanczos";
      result.light =
          scaleBands(light, [&](int l) { return l == 0 ? 1 : std::sin(pi * l / width) / (pi * l / width); });
      break;
    case Window::kAuto: {
      result.name = "auto";
      const double lambda = leastLambda(Irradiance(light));
      result.light = scaleBands(light, [&](int l) { return laplacianFactor(l, lambda); });
      break;
    }
  }
  const double before = directionalEnergy(light);
  if (before > 0) result.strength = std::max(0.0, 1 - directionalEnergy(result.light) / before);
  result.minimumIrradiance = Irradiance(result.light).minimum(0, true);
  return result;
}

}  // namespace shprt
