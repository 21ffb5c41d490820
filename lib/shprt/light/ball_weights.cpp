// The rim of a ball shows the surroundings of one direction in ever fewer pixels, so plain sums over pixels
// lose three digits on the mirrored ball. What they lose is nearly the same all around the axis. The factor
//   q(z) = sum_j a_j P_j(z)
// is the one nearest to 1 (least squares over the sphere) for which the sums of q P_j over the pixels are 4
// pi for j = 0 and 0 for 1 <= j <= degree: with 1 for q they miss by r_j, and G a = r corrects them, where
// G_jk is the sum of P_j P_k.

#include "shprt/light/ball_weights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "shprt/base/parallel.h"

namespace shprt {
namespace {

using std::numbers::pi;

void legendre(double z, std::vector<double>& values) {
  values[0] = 1;
  if (values.size() > 1) values[1] = z;
  for (std::size_t j = 2; j < values.size(); ++j) {
    const auto n = static_cast<double>(j);
    values[j] = ((2 * n - 1) * z * values[j - 1] - (n - 1) * values[j - 2]) / n;
  }
}

// Sums of P_j P_k over the pixels, row by row of a lower triangle; the first column holds the sums of P_j.
std::vector<double> sumProducts(EnvironmentLayout ball, int width, int height, int degree) {
  const auto count = static_cast<std::size_t>(degree) + 1;
  constexpr std::size_t kRowsPerBlock = 16;
  const auto rows = static_cast<std::size_t>(height);
  std::vector<std::vector<double>> blocks((rows + kRowsPerBlock - 1) / kRowsPerBlock);
  parallelForBlocks(rows, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
    std::vector<double>& sums = blocks[begin / kRowsPerBlock];
    sums.assign(count * (count + 1) / 2, 0.0);
    std::vector<double> values(count);
    for (std::size_t y = begin; y < end; ++y)
      for (int x = 0; x < width; ++x) {
        const PixelFootprint footprint = pixelFootprint(ball, width, height, x, static_cast<int>(y));
        if (footprint.solidAngle <= 0) continue;
        legendre(footprint.direction.z, values);
        double* sum = sums.data();
        for (std::size_t j = 0; j < count; ++j) {
          const double weighted = footprint.solidAngle * values[j];
          for (std::size_t k = 0; k <= j; ++k) *sum++ += weighted * values[k];
        }
      }
  });
  std::vector<double> total(count * (count + 1) / 2);
  for (const std::vector<double>& block : blocks)
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += block[i];
  return total;
}

// Solves G a = r by Cholesky's method for the leading part of G that r has the size of; false where G is not
// positive definite.
bool solve(const std::vector<double>& products, std::vector<double>& r) {
  const std::size_t count = r.size();
  std::vector<double> lower(products.begin(),
                            products.begin() + static_cast<std::ptrdiff_t>(count * (count + 1) / 2));
  const auto at = [&](std::size_t j, std::size_t k) -> double& { return lower[j * (j + 1) / 2 + k]; };
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t k = 0; k <= j; ++k) {
      double sum = at(j, k);
      for (std::size_t i = 0; i < k; ++i) sum -= at(j, i) * at(k, i);
      if (k < j) {
        at(j, k) = sum / at(k, k);
      } else {
        if (!(sum > 1e-9 * at(j, j))) return false;
        at(j, j) = std::sqrt(sum);
      }
    }
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t k = 0; k < j; ++k) r[j] -= at(j, k) * r[k];
    r[j] /= at(j, j);
  }
  for (std::size_t j = count; j-- > 0;) {
    for (std::size_t k = j + 1; k < count; ++k) r[j] -= at(k, j) * r[k];
    r[j] /= at(j, j);
  }
  return true;
}

}  // namespace

BallWeights::BallWeights(EnvironmentLayout ball, int width, int height, int degree) : series_{1} {
  const std::vector<double> products = sumProducts(ball, width, height, degree);
  for (int tried = degree;; tried = tried * 3 / 4) {
    std::vector<double> series(static_cast<std::size_t>(tried) + 1);
    for (std::size_t j = 0; j < series.size(); ++j)
      series[j] = (j == 0 ? 4 * pi : 0) - products[j * (j + 1) / 2];
    if (solve(products, series)) {
      series[0] += 1;
      series_.swap(series);
      const int steps = 8 * (tried + 1);  // an eighth of the shortest wave
      bool bounded = true;
      for (int i = 0; i <= steps && bounded; ++i) {
        const double q = factor(std::cos(pi * i / steps));
        bounded = q >= 0.25 && q <= 4;
      }
      if (bounded) return;
      series_ = {1};
    }
    if (tried == 0) return;
  }
}

double BallWeights::factor(double z) const {
  double sum = 0, before = 0, here = 1;
  for (std::size_t j = 0; j < series_.size(); ++j) {
    sum += series_[j] * here;
    const auto n = static_cast<double>(j);
    const double next = ((2 * n + 1) * z * here - n * before) / (n + 1);
    before = here;
    here = next;
  }
  return sum;
}

}  // namespace shprt
