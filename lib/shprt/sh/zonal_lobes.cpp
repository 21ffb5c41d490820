// Lobe weights by explicit inverses: the matrices are fixed, small and well conditioned by the choice of
// directions (lobe_directions.cpp), so a product with the inverse is as good as a solution.

#include "shprt/sh/zonal_lobes.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include "shprt/base/error.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

double lobeNorm(std::size_t l) {
  return std::sqrt(4 * std::numbers::pi / static_cast<double>(2 * l + 1));
}

// The inverse of a row-major n x n matrix by Gauss-Jordan elimination with partial pivoting.
std::vector<double> inverse(std::vector<double> a, std::size_t n) {
  std::vector<double> result(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) result[i * n + i] = 1;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::fabs(a[i * n + k]) > std::fabs(a[pivot * n + k])) pivot = i;
    for (std::size_t j = 0; j < n; ++j) {
      std::swap(a[k * n + j], a[pivot * n + j]);
      std::swap(result[k * n + j], result[pivot * n + j]);
    }
    const double scale = 1 / a[k * n + k];
    for (std::size_t j = 0; j < n; ++j) {
      a[k * n + j] *= scale;
      result[k * n + j] *= scale;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const double factor = a[i * n + k];
      if (i == k || factor == 0) continue;
      for (std::size_t j = 0; j < n; ++j) {
        a[i * n + j] -= factor * a[k * n + j];
        result[i * n + j] -= factor * result[k * n + j];
      }
    }
  }
  return result;
}

}  // namespace

ZonalLobes::ZonalLobes(int degree) : degree_(degree) {
  if (degree < 0 || degree > kMaximumLobeDegree)
    throw Error("zonal lobes", "there are no directions for degree " + std::to_string(degree),
                "give a degree from 0 to " + std::to_string(kMaximumLobeDegree));
  directions_ = lobeDirections(degree);
  const auto count = static_cast<std::size_t>(coefficientCount(degree));
  std::vector<double> harmonics(directions_.size() * count);
  for (std::size_t d = 0; d < directions_.size(); ++d)
    evaluateSh(degree, directions_[d], std::span(harmonics).subspan(d * count, count));
  for (std::size_t l = 0; l <= static_cast<std::size_t>(degree); ++l) {
    const std::size_t n = 2 * l + 1;
    std::vector<double> lobes(n * n);
    for (std::size_t row = 0; row < n; ++row)
      for (std::size_t d = 0; d < n; ++d)
        lobes[row * n + d] = lobeNorm(l) * harmonics[d * count + l * l + row];
    const std::vector<double> inverted = inverse(std::move(lobes), n);
    inverses_.insert(inverses_.end(), inverted.begin(), inverted.end());
  }
}

void ZonalLobes::weights(std::span<const double> coefficients, std::span<double> weights) const {
  assert(coefficients.size() == static_cast<std::size_t>(coefficientCount(degree_)));
  assert(weights.size() == coefficients.size());
  const double* row = inverses_.data();
  for (std::size_t l = 0; l <= static_cast<std::size_t>(degree_); ++l)
    for (std::size_t d = 0; d < 2 * l + 1; ++d) {
      double sum = 0;
      for (std::size_t m = 0; m < 2 * l + 1; ++m) sum += row[m] * coefficients[l * l + m];
      weights[l * l + d] = sum;
      row += 2 * l + 1;
    }
}

void ZonalLobes::rotate(const Mat3& rotation, std::span<double> coefficients) const {
  std::vector<double> lobeWeights(coefficients.size());
  weights(coefficients, lobeWeights);
  std::vector<Vec3d> turned;
  turned.reserve(directions_.size());
  for (const Vec3d& direction : directions_) turned.push_back(normalize(rotation * direction));
  lobeCoefficients(turned, lobeWeights, coefficients);
}

void lobeCoefficients(std::span<const Vec3d> directions, std::span<const double> weights,
                      std::span<double> coefficients) {
  const std::size_t degree = directions.size() / 2;
  assert(directions.size() == 2 * degree + 1 && coefficients.size() == (degree + 1) * (degree + 1));
  assert(weights.size() == coefficients.size());
  for (double& coefficient : coefficients) coefficient = 0;
  std::vector<double> harmonics(coefficients.size());
  for (std::size_t d = 0; d < directions.size(); ++d) {
    evaluateSh(static_cast<int>(degree), directions[d], harmonics);
    for (std::size_t l = (d + 1) / 2; l <= degree; ++l) {
      const double weight = lobeNorm(l) * weights[l * l + d];
      for (std::size_t i = l * l; i < (l + 1) * (l + 1); ++i) coefficients[i] += weight * harmonics[i];
    }
  }
}

double evaluateLobes(std::span<const Vec3d> directions, std::span<const double> weights, Vec3d u) {
  const std::size_t degree = directions.size() / 2;
  assert(directions.size() == 2 * degree + 1 && weights.size() == (degree + 1) * (degree + 1));
  double sum = 0;
  for (std::size_t d = 0; d < directions.size(); ++d) {
    const double cosTheta = dot(directions[d], u);
    double previous = 0, legendre = 1;
    for (std::size_t l = 0; l <= degree; ++l) {
      if (d < 2 * l + 1) sum += weights[l * l + d] * legendre / lobeNorm(l);
      const auto order = static_cast<double>(l);
      const double next = ((2 * order + 1) * cosTheta * legendre - order * previous) / (order + 1);
      previous = legendre;
      legendre = next;
    }
  }
  return sum;
}

}  // namespace shprt
