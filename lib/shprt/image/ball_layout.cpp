// The two balls on the unit disc, u to the right and v up: a point at radius r shows the direction at angle
// theta(r) from the middle's, pi r for the angular map and 2 asin(r) for the mirrored ball.
//
// The solid angle of a region is the integral of (1 - cos theta) d(phi) along its outline (Green's theorem).
// On the circle the integrand is 2; along a pixel's edge it is the distance of the edge's line times the
// entire function (1 - cos theta) / r^2, which a Gauss rule integrates to rounding. So pixels that the circle
// cuts are as exact as those inside. Based on: Debevec 1998.

#include "shprt/image/ball_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace shprt {
namespace {

using std::numbers::pi;

// Direction at a point of the unit disc.
Vec3d ballDirection(Ball ball, double u, double v) {
  const double r = std::hypot(u, v);
  const double theta = ball == Ball::kMirrored ? 2 * std::asin(std::min(r, 1.0)) : pi * std::min(r, 1.0);
  const double across = r > 0 ? std::sin(theta) / r : 0;
  return {-across * u, across * v, ball == Ball::kMirrored ? -std::cos(theta) : std::cos(theta)};
}

// Solid angle per area of the disc: Lambert's equal-area projection for the mirrored ball.
double ballDensity(Ball ball, double r) {
  if (ball == Ball::kMirrored) return 4;
  return r < 1e-9 ? pi * pi : pi * std::sin(pi * r) / r;
}

// (1 - cos theta) / r^2.
double capDensity(Ball ball, double r) {
  if (ball == Ball::kMirrored) return 2;
  if (r < 1e-9) return pi * pi / 2;
  const double half = std::sin(pi * r / 2) / r;
  return 2 * half * half;
}

struct GaussPoint {
  double at, weight;  // on [0, 1]
};
constexpr std::size_t kGaussPoints = 16;

std::array<GaussPoint, kGaussPoints> makeGaussRule() {
  std::array<GaussPoint, kGaussPoints> rule;
  constexpr int n = kGaussPoints;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(pi * (i + 0.75) / (n + 0.5)), slope = 1;
    for (int step = 0; step < 8; ++step) {  // Newton's method on the Legendre polynomial
      double before = 1, here = x;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * here - (k - 1) * before) / k;
        before = here;
        here = next;
      }
      slope = n * (x * here - before) / (x * x - 1);
      x -= here / slope;
    }
    rule[static_cast<std::size_t>(i)] = {(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)};
  }
  return rule;
}

// Solid angle of [0,u] x [0,v] within the disc, for u, v in [0,1].
double cornerAngle(Ball ball, double u, double v) {
  static const std::array<GaussPoint, kGaussPoints> kRule = makeGaussRule();
  const auto edge = [&](double distance, double end) {
    end = std::min(end, std::sqrt(std::max(0.0, 1 - distance * distance)));
    double sum = 0;
    for (const GaussPoint& point : kRule)
      sum += point.weight * capDensity(ball, std::hypot(distance, end * point.at));
    return distance * end * sum;
  };
  const double arc = std::max(0.0, std::asin(v) - std::acos(u));
  return edge(u, v) + edge(v, u) + 2 * arc;
}

// Of a rectangle within the disc, by its four corners.
double cutPixelAngle(Ball ball, double left, double right, double bottom, double top) {
  const auto corner = [&](double u, double v) {
    return std::copysign(1.0, u * v) *
           cornerAngle(ball, std::min(std::abs(u), 1.0), std::min(std::abs(v), 1.0));
  };
  return std::max(0.0, corner(right, top) - corner(left, top) - corner(right, bottom) + corner(left, bottom));
}

// Of a rectangle inside the disc: the three-point Gauss rule in both directions.
double wholePixelAngle(Ball ball, double u, double v, double width, double height) {
  constexpr std::array<GaussPoint, 3> kRule = {
      {{-0.38729833462074168852, 5.0 / 18}, {0, 8.0 / 18}, {0.38729833462074168852, 5.0 / 18}}};
  double density = 0;
  for (const GaussPoint& a : kRule)
    for (const GaussPoint& b : kRule)
      density += a.weight * b.weight * ballDensity(ball, std::hypot(u + a.at * width, v + b.at * height));
  return density * width * height;
}

// The mean direction over the part of a rectangle that lies inside the disc.
Vec3d cutPixelDirection(Ball ball, double u, double v, double width, double height) {
  constexpr int kSteps = 16;
  Vec3d sum;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double a = u + ((i + 0.5) / kSteps - 0.5) * width, b = v + ((j + 0.5) / kSteps - 0.5) * height;
      const double r = std::hypot(a, b);
      if (r < 1) sum += ballDirection(ball, a, b) * ballDensity(ball, r);
    }
  // A sliver that none of the points hits shows what the rim shows.
  return sum == Vec3d{} ? ballDirection(ball, u, v) : normalize(sum);
}

}  // namespace

PixelFootprint ballFootprint(Ball ball, int width, int height, int x, int y) {
  const double left = 2.0 * x / width - 1, right = 2.0 * (x + 1) / width - 1;
  const double top = 1 - 2.0 * y / height, bottom = 1 - 2.0 * (y + 1) / height;
  const double u = (left + right) / 2, v = (top + bottom) / 2;
  const double farthest = std::hypot(std::max(-left, right), std::max(-bottom, top));
  if (farthest <= 1)
    return {ballDirection(ball, u, v), wholePixelAngle(ball, u, v, right - left, top - bottom)};
  const double nearest = std::hypot(std::max({left, -right, 0.0}), std::max({bottom, -top, 0.0}));
  if (nearest >= 1) return {};
  const double angle = cutPixelAngle(ball, left, right, bottom, top);
  // Differences of corners leave their rounding where the circle only grazes a pixel.
  if (angle <= 1e-14) return {};
  return {cutPixelDirection(ball, u, v, right - left, top - bottom), angle};
}

PixelPosition ballPosition(Ball ball, int width, int height, Vec3d direction) {
  const bool mirrored = ball == Ball::kMirrored;
  const double across = std::hypot(direction.x, direction.y);
  const double theta = std::atan2(across, mirrored ? -direction.z : direction.z);
  const double r = mirrored ? std::sin(theta / 2) : theta / pi;
  const double u = across > 0 ? -direction.x / across * r : 0, v = across > 0 ? direction.y / across * r : 0;
  return {(u + 1) / 2 * width, (1 - v) / 2 * height};
}

}  // namespace shprt
