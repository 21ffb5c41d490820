#include "shprt/transfer/point_errors.h"

#include <numeric>

namespace shprt {

void addSquares(std::span<const double> contrast, std::size_t point, PointErrors& errors) {
  const ErrorLayout& layout = errors.layout;
  float* row = errors.squares.row(point);
  std::size_t next = 0;
  for (int channel = 0; channel < layout.channels; ++channel)
    for (int band = 0; band <= layout.degree; ++band) {
      double square = 0;
      for (int i = 0; i < 2 * band + 1; ++i, ++next) square += contrast[next] * contrast[next];
      row[layout.column(channel, band)] += static_cast<float>(square);
    }
  if (!layout.emission) return;
  for (std::size_t i = 0; i < 3; ++i, ++next)
    row[layout.emissionColumn() + i] += static_cast<float>(contrast[next] * contrast[next]);
}

void storeRate(const std::array<std::span<const double>, 3>& contrasts, double sixteenthSquare,
               std::size_t point, PointErrors& errors) {
  double square = 0;
  for (const std::span<const double> contrast : contrasts)
    square = std::inner_product(contrast.begin(), contrast.end(), contrast.begin(), square);
  errors.quarters[point] = static_cast<float>(square);
  errors.sixteenths[point] = static_cast<float>(sixteenthSquare);
}

}  // namespace shprt
