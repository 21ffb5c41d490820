// Piecewise constant densities over the sphere: a row by its share, a cell by its share of the row, and
// a direction uniform over the cell. Based on: Pharr, Jakob and Humphreys 2023 (sampling of image lights by
// marginal and conditional distributions).

#include "shprt/transfer/sky_sampler.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <span>

#include "shprt/base/parallel.h"

namespace shprt {
namespace {

using std::numbers::pi;

constexpr double kLeak = 1.0 / 64;  // of a cell's magnitude, into each of the eight around it

Vec3d directionAt(double height, double turns) {
  const double radius = std::sqrt(std::max(0.0, 1 - height * height)), phi = pi * (1 - 2 * turns);
  return {radius * std::sin(phi), height, radius * std::cos(phi)};
}

// Makes sums of what are not negative end at 1; returns the total.
double cumulate(std::span<double> values) {
  double total = 0;
  for (double& value : values) value = total += value;
  for (double& value : values) value = total > 0 ? value / total : 1;
  values.back() = 1;
  return total;
}

// The interval of cumulated probabilities that u in [0,1) falls into, and where in it, in [0,1).
std::size_t findInterval(std::span<const double> ends, double u, double& within) {
  const auto found = static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), u) - ends.begin());
  const double begin = found == 0 ? 0 : ends[found - 1];
  within = std::clamp((u - begin) / (ends[found] - begin), 0.0, 1.0);
  return found;
}

}  // namespace

SkySampler::SkySampler(int rows, int columns, const std::function<double(Vec3d)>& magnitude)
    : rows_(static_cast<std::size_t>(rows)),
      columns_(static_cast<std::size_t>(columns)),
      rowEnds_(rows_),
      cellEnds_(rows_ * columns_),
      densities_(rows_ * columns_) {
  assert(rows >= 1 && columns >= 1);
  for (int row = 0; row <= rows; ++row) heights_.push_back(std::cos(pi * row / rows));
  std::vector<double> means(densities_.size());
  parallelForBlocks(rows_, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      for (std::size_t column = 0; column < columns_; ++column) {
        double sum = 0;
        for (const double y : {1. / 6, 0.5, 5. / 6})
          for (const double x : {1. / 6, 0.5, 5. / 6})
            sum += magnitude(directionAt(heights_[row] + (heights_[row + 1] - heights_[row]) * y,
                                         (static_cast<double>(column) + x) / static_cast<double>(columns_)));
        means[cell(row, column)] = sum / 9;
      }
  });
  if (std::all_of(means.begin(), means.end(), [](double mean) { return mean <= 0; }))
    std::fill(means.begin(), means.end(), 1.0);

  for (std::size_t row = 0; row < rows_; ++row) {
    const double solidAngle = 2 * pi * (heights_[row] - heights_[row + 1]) / static_cast<double>(columns_);
    for (std::size_t column = 0; column < columns_; ++column) {
      double leaked = 0;
      for (const std::size_t r : {row == 0 ? 0 : row - 1, row, std::min(row + 1, rows_ - 1)})
        for (const std::size_t step : {columns_ - 1, std::size_t{0}, std::size_t{1}})
          leaked += kLeak * means[cell(r, (column + step) % columns_)];
      densities_[cell(row, column)] = means[cell(row, column)] + leaked;
      cellEnds_[cell(row, column)] = densities_[cell(row, column)] * solidAngle;
    }
    rowEnds_[row] = cumulate(std::span(cellEnds_).subspan(row * columns_, columns_));
  }
  const double total = cumulate(rowEnds_);
  for (double& density : densities_) density /= total;
}

Vec3d SkySampler::sample(double u, double v) const {
  double y, x;
  const std::size_t row = findInterval(rowEnds_, v, y);
  const std::size_t column = findInterval(std::span(cellEnds_).subspan(row * columns_, columns_), u, x);
  return directionAt(heights_[row] + (heights_[row + 1] - heights_[row]) * y,
                     (static_cast<double>(column) + x) / static_cast<double>(columns_));
}

double SkySampler::density(Vec3d direction) const {
  const double theta = std::atan2(std::hypot(direction.x, direction.z), direction.y);
  const double turns = (1 - std::atan2(direction.x, direction.z) / pi) / 2;
  const auto indexOf = [](double share, std::size_t count) {
    return std::min(static_cast<std::size_t>(share * static_cast<double>(count)), count - 1);
  };
  return densities_[cell(indexOf(theta / pi, rows_), indexOf(turns, columns_))];
}

}  // namespace shprt
