#include "shprt/scene/point_triangle_distance.h"

#include <algorithm>

namespace shprt {
namespace {

double pointSegmentDistance(Vec3d point, Vec3d a, Vec3d b) {
  const Vec3d along = b - a;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(point - a, along) / squared, 0.0, 1.0) : 0.0;
  return length(point - (a + along * t));
}

}  // namespace

double pointTriangleDistance(Vec3d point, Vec3d a, Vec3d b, Vec3d c) {
  const Vec3d normal = cross(b - a, c - a);
  const double area = length(normal);
  const bool inside = area > 0 && dot(cross(b - a, point - a), normal) >= 0 &&
                      dot(cross(c - b, point - b), normal) >= 0 && dot(cross(a - c, point - c), normal) >= 0;
  if (inside) return std::abs(dot(point - a, normal)) / area;
  return std::min({pointSegmentDistance(point, a, b), pointSegmentDistance(point, b, c),
                   pointSegmentDistance(point, c, a)});
}

}  // namespace shprt
