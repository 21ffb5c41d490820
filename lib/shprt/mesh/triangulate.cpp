// Ear clipping in the projection along the largest component of the polygon's normal.
// Based on: Meisters 1975 (two ears theorem); Newell's formula for the normal of a polygon.

#include "shprt/mesh/triangulate.h"

#include <algorithm>
#include <cmath>

namespace shprt {
namespace {

struct Point {
  double x, y;
};

// Positive when a, b, c turn counter-clockwise.
double turn(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool same(Point a, Point b) {
  return a.x == b.x && a.y == b.y;
}

double largestDifference(Vec3d a) {
  return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

// The polygon seen from the side it faces, so that it runs counter-clockwise.
std::vector<Point> project(std::span<const Vec3d> corners) {
  const Vec3d origin = corners[0];
  double scale = 0;
  for (const Vec3d& corner : corners) scale = std::max(scale, largestDifference(corner - origin));
  if (!(scale > 0)) scale = 1;
  std::vector<Vec3d> local;
  for (const Vec3d& corner : corners) local.push_back((corner - origin) / scale);
  Vec3d normal;
  for (std::size_t i = 0; i < local.size(); ++i) normal += cross(local[i], local[(i + 1) % local.size()]);
  std::vector<Point> points;
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  for (const Vec3d& p : local) {
    if (z >= x && z >= y)
      points.push_back(normal.z < 0 ? Point{p.y, p.x} : Point{p.x, p.y});
    else if (x >= y)
      points.push_back(normal.x < 0 ? Point{p.z, p.y} : Point{p.y, p.z});
    else
      points.push_back(normal.y < 0 ? Point{p.x, p.z} : Point{p.z, p.x});
  }
  return points;
}

bool isConvex(const std::vector<Point>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (turn(points[i], points[(i + 1) % points.size()], points[(i + 2) % points.size()]) < 0) return false;
  }
  return true;
}

// Whether p lies in the closed triangle a, b, c. Corners that share a place with the ear do not block it.
bool blocks(Point p, Point a, Point b, Point c) {
  if (same(p, a) || same(p, b) || same(p, c)) return false;
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

void clipEars(const std::vector<Point>& points, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const std::size_t count = points.size();
  std::vector<std::uint32_t> next(count), previous(count);
  for (std::size_t i = 0; i < count; ++i) {
    next[i] = static_cast<std::uint32_t>((i + 1) % count);
    previous[i] = static_cast<std::uint32_t>((i + count - 1) % count);
  }
  const auto isEar = [&](std::uint32_t b) {
    const std::uint32_t a = previous[b], c = next[b];
    if (turn(points[a], points[b], points[c]) <= 0) return false;
    for (std::uint32_t p = next[c]; p != a; p = next[p]) {
      if (blocks(points[p], points[a], points[b], points[c])) return false;
    }
    return true;
  };
  std::uint32_t current = 0;
  std::size_t left = count, refused = 0;
  while (left > 3) {
    // When a whole round finds no ear (collinear or crossing corners), a corner is cut off flat; the loop
    // always ends.
    const bool flat = refused >= left;
    if (isEar(current) ||
        (flat && turn(points[previous[current]], points[current], points[next[current]]) == 0) ||
        refused >= 2 * left) {
      triangles.push_back({previous[current], current, next[current]});
      next[previous[current]] = next[current];
      previous[next[current]] = previous[current];
      current = previous[current];
      --left;
      refused = 0;
    } else {
      current = next[current];
      ++refused;
    }
  }
  triangles.push_back({previous[current], current, next[current]});
}

}  // namespace

bool triangulate(std::span<const Vec3d> corners, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  if (count == 3) {
    triangles.push_back({0, 1, 2});
    return true;
  }
  const std::vector<Point> points = project(corners);
  constexpr std::uint32_t kMaximumClipped = 4096;
  if (count == 4 && isConvex(points)) {
    // The shorter diagonal makes the better triangles.
    const Vec3d even = corners[2] - corners[0], odd = corners[3] - corners[1];
    if (dot(odd, odd) < dot(even, even)) {
      triangles.insert(triangles.end(), {{1, 2, 3}, {1, 3, 0}});
    } else {
      triangles.insert(triangles.end(), {{0, 1, 2}, {0, 2, 3}});
    }
    return true;
  }
  const bool convex = isConvex(points);
  if (!convex && count <= kMaximumClipped) {
    clipEars(points, triangles);
    return true;
  }
  for (std::uint32_t i = 1; i + 1 < count; ++i) triangles.push_back({0, i, i + 1});
  return convex;
}

Vec3d areaDirection(Vec3d a, Vec3d b, Vec3d c) {
  const Vec3d first = b - a, second = c - a;
  const double scale1 = largestDifference(first), scale2 = largestDifference(second);
  if (!(scale1 > 0) || !(scale2 > 0)) return {};
  return cross(first / scale1, second / scale2);
}

}  // namespace shprt
