// Functions over the hemisphere around +z with known means under the density cos(theta)/pi. Projected to the
// plane, that density is uniform over the unit disc, so the mean of an indicator is an area over pi.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/sampling/hemisphere_set.h"

namespace shprt::test {

struct DiscIntegrand {
  std::string name;
  std::function<double(Vec3d)> value;
  double mean;
};

// Moments: with r^2 = x^2 + y^2 uniform in [0,1] and z^2 = 1 - r^2, E z^k = 2/(k+2) and E x^2 = E r^2 / 2;
// E x^2 y^2 = E r^4 / 8, and E x^2 z = E r^2 z / 2 = (E z - E z^3) / 2.
inline std::vector<DiscIntegrand> smoothIntegrands() {
  return {{"x", [](Vec3d d) { return d.x; }, 0},
          {"z", [](Vec3d d) { return d.z; }, 2.0 / 3},
          {"x x", [](Vec3d d) { return d.x * d.x; }, 1.0 / 4},
          {"x y", [](Vec3d d) { return d.x * d.y; }, 0},
          {"x x y y", [](Vec3d d) { return d.x * d.x * d.y * d.y; }, 1.0 / 24},
          {"x x z", [](Vec3d d) { return d.x * d.x * d.z; }, 2.0 / 15}};
}

inline DiscIntegrand halfPlane(double azimuth, double distance) {
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  return {"half plane at " + std::to_string(distance),
          [=](Vec3d d) { return c * d.x + s * d.y > distance ? 1.0 : 0.0; },
          (std::acos(distance) - distance * std::sqrt(1 - distance * distance)) / std::numbers::pi};
}

// Centred at distance `centre` along azimuth; centre + radius <= 1.
inline DiscIntegrand disc(double azimuth, double centre, double radius) {
  const double x = centre * std::cos(azimuth), y = centre * std::sin(azimuth);
  return {"disc at " + std::to_string(centre),
          [=](Vec3d d) { return std::hypot(d.x - x, d.y - y) < radius ? 1.0 : 0.0; }, radius * radius};
}

inline std::vector<DiscIntegrand> discontinuousIntegrands() {
  return {halfPlane(0.4, 0.0), halfPlane(2.1, 0.35),  halfPlane(5.0, -0.8),
          disc(1.0, 0.0, 0.6), disc(3.3, 0.45, 0.45), disc(0.2, 0.7, 0.15)};
}

// The directions around +z that (seed, index) names, without padding.
inline std::vector<Vec3d> directionsOf(const HemisphereSet& set, std::uint64_t seed, std::uint64_t index) {
  std::vector<float> x(set.paddedCount()), y(x.size()), z(x.size());
  set.directions({0, 0, 1}, seed, index, x.data(), y.data(), z.data());
  std::vector<Vec3d> directions;
  for (std::size_t i = 0; i < static_cast<std::size_t>(set.count()); ++i)
    directions.push_back({x[i], y[i], z[i]});
  return directions;
}

inline double meanOver(const std::vector<Vec3d>& directions, const DiscIntegrand& f) {
  double sum = 0;
  for (const Vec3d d : directions) sum += f.value(d);
  return sum / static_cast<double>(directions.size());
}

// A running mean with its standard error.
class Average {
 public:
  void add(double value) {
    ++count_;
    const double step = value - mean_;
    mean_ += step / count_;
    squares_ += step * (value - mean_);
  }
  double mean() const { return mean_; }
  double standardError() const { return std::sqrt(squares_ / (count_ * (count_ - 1.0))); }

 private:
  int count_ = 0;
  double mean_ = 0, squares_ = 0;
};

}  // namespace shprt::test
