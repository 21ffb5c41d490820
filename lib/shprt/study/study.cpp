#include "shprt/study/study.h"

#include <algorithm>
#include <cmath>

namespace shprt {

std::optional<double> fitSlope(const std::vector<std::pair<double, double>>& points) {
  double count = 0, sumX = 0, sumY = 0;
  const auto usable = [](const auto& point) { return point.first > 0 && point.second > 0; };
  for (const auto& point : points) {
    if (!usable(point)) continue;
    ++count, sumX += std::log(point.first), sumY += std::log(point.second);
  }
  if (count < 2) return {};
  double xx = 0, xy = 0;
  for (const auto& point : points) {
    if (!usable(point)) continue;
    const double x = std::log(point.first) - sumX / count, y = std::log(point.second) - sumY / count;
    xx += x * x, xy += x * y;
  }
  if (!(xx > 0)) return {};
  return xy / xx;
}

std::vector<std::pair<double, double>> beyondFixedCosts(std::vector<std::pair<double, double>> points) {
  if (points.empty()) return points;
  const double shortest = std::min_element(points.begin(), points.end())->first;
  std::erase_if(points, [&](const auto& point) { return point.first < 2 * shortest; });
  return points;
}

}  // namespace shprt
