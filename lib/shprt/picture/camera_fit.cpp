// The tightest perspective view of a point set. In camera axes (x right, y up, z back) a point p is inside
// the left and right planes of an eye e exactly when |p.x - e.x| <= t (e.z - p.z), t the tangent of the half
// angle; so e.z >= (max(p.x + t p.z) + max(-p.x + t p.z)) / 2t, with e.x half their difference. The same for
// y; the larger e.z serves both.
#include "shprt/picture/camera_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "shprt/base/frame.h"

namespace shprt {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

// From the front, a little above and to the right.
constexpr double kDefaultAzimuth = 25, kDefaultElevation = 20;

// Support of the points along x + t z and -x + t z.
struct Slopes {
  double plus = -std::numeric_limits<double>::infinity();
  double minus = -std::numeric_limits<double>::infinity();

  void add(double x, double z, double tangent) {
    plus = std::max(plus, x + tangent * z);
    minus = std::max(minus, -x + tangent * z);
  }
  double middle() const { return 0.5 * (plus - minus); }
  double eyeDepth(double tangent) const { return 0.5 * (plus + minus) / tangent; }
};

// Where along one axis the eye sees the points' two ends equally far from the picture's middle. The axis that
// decides the distance is there already; on the other, the slack is shared between both sides.
double balance(std::span<const Vec3f> positions, Vec3d axis, Vec3d back, double eyeDepth, double middle) {
  constexpr int kRounds = 6;  // each is exact for the ends it finds, and the ends change rarely
  for (int round = 0; round < kRounds; ++round) {
    double highest = -std::numeric_limits<double>::infinity(), lowest = -highest;
    double high = middle, low = middle, highDepth = 1, lowDepth = 1;
    for (const Vec3f& position : positions) {
      const Vec3d p = toDouble(position);
      const double along = dot(p, axis), depth = eyeDepth - dot(p, back);
      const double seen = (along - middle) / depth;
      if (seen > highest) highest = seen, high = along, highDepth = depth;
      if (seen < lowest) lowest = seen, low = along, lowDepth = depth;
    }
    middle = (high * lowDepth + low * highDepth) / (highDepth + lowDepth);
  }
  return middle;
}

}  // namespace

CameraAxes cameraAxes(Vec3d back, Vec3d up) {
  back = normalize(back);
  const Vec3d right = cross(normalize(up), back);
  if (length(right) < 1e-9) {
    const Frame frame = frameFromNormal(back);
    return {frame.tangent, frame.bitangent, back};
  }
  const Vec3d unitRight = normalize(right);
  return {unitRight, cross(back, unitRight), back};
}

Camera fitCamera(std::span<const Vec3f> positions, Vec3d directionToEye, Vec3d up, double verticalFovDegrees,
                 double aspect) {
  assert(!positions.empty() && aspect > 0);
  const CameraAxes axes = cameraAxes(directionToEye, up);
  const double tangent = std::tan(0.5 * verticalFovDegrees * kRadiansPerDegree) * (1 - kFrameMargin);
  Slopes horizontal, vertical;
  double nearest = -std::numeric_limits<double>::infinity(), farthest = -nearest;
  for (const Vec3f& position : positions) {
    const Vec3d p = toDouble(position);
    const double z = dot(p, axes.back);
    horizontal.add(dot(p, axes.right), z, tangent * aspect);
    vertical.add(dot(p, axes.up), z, tangent);
    nearest = std::max(nearest, z);
    farthest = std::min(farthest, z);
  }
  double depth = std::max(horizontal.eyeDepth(tangent * aspect), vertical.eyeDepth(tangent));
  // Points on one line of sight would put the eye onto the nearest of them.
  const double size =
      std::max({depth - farthest, nearest - farthest, std::numeric_limits<float>::min() * 1.0});
  depth = std::max(depth, nearest + 1e-3 * size);

  Camera camera;
  const double x = balance(positions, axes.right, axes.back, depth, horizontal.middle());
  const double y = balance(positions, axes.up, axes.back, depth, vertical.middle());
  const Vec3d axis = axes.right * x + axes.up * y;
  camera.eye = axis + axes.back * depth;
  camera.target = axis + axes.back * (0.5 * (nearest + farthest));
  camera.up = axes.up;
  camera.verticalFovDegrees = verticalFovDegrees;
  return camera;
}

OrbitDirection orbitDirection(double azimuthDegrees, double elevationDegrees) {
  const double azimuth = azimuthDegrees * kRadiansPerDegree, elevation = elevationDegrees * kRadiansPerDegree;
  const Vec3d horizontal{std::sin(azimuth), 0, std::cos(azimuth)};
  const Vec3d zenith{0, 1, 0};
  return {horizontal * std::cos(elevation) + zenith * std::sin(elevation),
          zenith * std::cos(elevation) - horizontal * std::sin(elevation)};
}

Camera frameCamera(std::span<const Vec3f> positions, double aspect) {
  const OrbitDirection direction = orbitDirection(kDefaultAzimuth, kDefaultElevation);
  return fitCamera(positions, direction.toEye, direction.up, Camera{}.verticalFovDegrees, aspect);
}

}  // namespace shprt
