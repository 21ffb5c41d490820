// The irradiance is the light convolved with the clamped cosine. It, or the radiance itself, is looked at on
// a grid of spacing pi / (6 (degree + 2)), so at most 0.37 / degree from anywhere, and followed downhill from
// the local minima there. What differs from the average bends by at most degree^2 times its largest value
// (Bernstein), so the least value lies at most 0.07 of that below the grid point beside it, and only minima
// that can reach below the lowest one known are followed.

#include "shprt/light/irradiance_minimum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "shprt/base/parallel.h"
#include "shprt/base/vec.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/zonal.h"

namespace shprt {
namespace {

using std::numbers::pi;

// Half of 0.37^2, and a little for a largest deviation between grid points.
constexpr double kDeepestDip = 0.08;
constexpr double kRounding = 1e-13;

// A function on the sphere by its coefficients, and its values on a grid of directions.
class GriddedFunction {
 public:
  GriddedFunction(int degree, std::vector<double> coefficients)
      : degree_(degree),
        rows_(6 * (degree + 2)),
        columns_(2 * rows_),
        coefficients_(std::move(coefficients)),
        values_(static_cast<std::size_t>(rows_ + 1) * static_cast<std::size_t>(columns_)) {
    parallelForBlocks(static_cast<std::size_t>(rows_) + 1, 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row) fillRow(static_cast<int>(row));
    });
  }

  double minimum() const {
    double least = *std::min_element(values_.begin(), values_.end()), deviation = 0;
    for (const double value : values_) deviation = std::max(deviation, std::abs(value - 1));
    for (const auto& [value, direction] : localMinima()) {
      if (value - kDeepestDip * deviation >= least) break;
      least = std::min(least, descend(direction, value, kRounding * std::max(1.0, deviation)));
    }
    return least;
  }

 private:
  std::size_t indexOf(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  Vec3d directionAt(std::size_t point) const {
    const auto columns = static_cast<std::size_t>(columns_);
    const double theta = pi * static_cast<double>(point / columns) / rows_,
                 phi = 2 * pi * static_cast<double>(point % columns) / columns_;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
  }

  // Around a circle of latitude the function is a trigonometric polynomial of its degree; its coefficients
  // are sums over l of harmonics at azimuth 0, where those of m < 0 vanish and lend their place.
  void fillRow(int row) {
    std::vector<double> basis(coefficients_.size());
    evaluateSh(degree_, directionAt(indexOf(row, 0)), basis);
    std::vector<double> cosines(static_cast<std::size_t>(degree_) + 1), sines(cosines.size());
    for (int l = 0; l <= degree_; ++l)
      for (int m = 0; m <= l; ++m) {
        const double y = basis[static_cast<std::size_t>(shIndex(l, m))];
        cosines[static_cast<std::size_t>(m)] += coefficients_[static_cast<std::size_t>(shIndex(l, m))] * y;
        sines[static_cast<std::size_t>(m)] += coefficients_[static_cast<std::size_t>(shIndex(l, -m))] * y;
      }
    for (int column = 0; column < columns_; ++column) {
      const double phi = 2 * pi * column / columns_, c = std::cos(phi), s = std::sin(phi);
      double sum = cosines[0], re = 1, im = 0;
      for (std::size_t m = 1; m < cosines.size(); ++m) {
        const double next = re * c - im * s;
        im = re * s + im * c;
        re = next;
        sum += cosines[m] * re + sines[m] * im;
      }
      values_[indexOf(row, column)] = sum;
    }
  }

  double evaluate(Vec3d direction, std::vector<double>& basis) const {
    evaluateSh(degree_, direction, basis);
    double sum = 0;
    for (std::size_t i = 0; i < basis.size(); ++i) sum += coefficients_[i] * basis[i];
    return sum;
  }

  // A pole is one direction, so only its first column counts.
  bool isLocalMinimum(int i, int j) const {
    if ((i == 0 || i == rows_) && j > 0) return false;
    const double here = values_[indexOf(i, j)];
    for (int row = std::max(0, i - 1); row <= std::min(rows_, i + 1); ++row)
      for (const int column : {(j + columns_ - 1) % columns_, j, (j + 1) % columns_})
        if (values_[indexOf(row, column)] < here) return false;
    return true;
  }

  // Values and directions, the lowest first.
  std::vector<std::pair<double, Vec3d>> localMinima() const {
    std::vector<std::pair<double, Vec3d>> minima;
    for (int i = 0; i <= rows_; ++i)
      for (int j = 0; j < columns_; ++j) {
        if (isLocalMinimum(i, j)) minima.emplace_back(values_[indexOf(i, j)], directionAt(indexOf(i, j)));
      }
    std::stable_sort(minima.begin(), minima.end(),
                     [](const auto& one, const auto& other) { return one.first < other.first; });
    return minima;
  }

  // Pattern search: tries four neighbours at a step that halves when none is lower. Without a threshold it
  // would stroll through valleys, which lights with an axis have, on differences of rounding.
  double descend(Vec3d here, double value, double threshold) const {
    std::vector<double> basis(coefficients_.size());
    for (double step = pi / rows_ / 2; step > 1e-6;) {
      const Vec3d side = normalize(cross(here, std::abs(here.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0})),
                  up = cross(side, here);
      bool lower = false;
      for (const Vec3d offset : {side, -side, up, -up}) {
        const Vec3d there = normalize(here + offset * step);
        const double candidate = evaluate(there, basis);
        if (!(candidate < value - threshold)) continue;
        value = candidate;
        here = there;
        lower = true;
        break;
      }
      if (!lower) step /= 2;
    }
    return value;
  }

  int degree_, rows_, columns_;
  std::vector<double> coefficients_, values_;
};

// Least over directions and colours of the light with band l multiplied by factors[l] / factors[0], relative
// to each colour's average.
double leastRelativeValue(const LightCoefficients& light, const std::vector<double>& factors) {
  double least = 1;  // the average
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const double average = light.coefficients[0][colour];
    if (!(average > 0)) continue;
    std::vector<double> relative;
    for (int l = 0; l <= light.degree; ++l)
      for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i)
        relative.push_back(factors[static_cast<std::size_t>(l)] / factors[0] * std::sqrt(4 * pi) *
                           (light.coefficients[static_cast<std::size_t>(i)][colour] / average));
    least = std::min(least, GriddedFunction(light.degree, std::move(relative)).minimum());
  }
  return least;
}

}  // namespace

double leastRelativeIrradiance(const LightCoefficients& light) {
  return leastRelativeValue(light, clampedCosineFactors(light.degree));
}

double leastRelativeRadiance(const LightCoefficients& light) {
  return leastRelativeValue(light, std::vector<double>(static_cast<std::size_t>(light.degree) + 1, 1.0));
}

}  // namespace shprt
