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

// Without collinear corners, which a fan would leave out of every triangle with area.
bool isStrictlyConvex(const std::vector<Point>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (turn(points[i], points[(i + 1) % points.size()], points[(i + 2) % points.size()]) <= 0) return false;
  }
  return true;
}

// Whether p lies in the triangle or on its border.
bool inTriangle(Point p, Point a, Point b, Point c) {
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

// The rest of a polygon, linked in a ring; ears are cut off it one by one.
class EarClipping {
 public:
  explicit EarClipping(const std::vector<Point>& points)
      : points_(points),
        next_(points.size()),
        previous_(points.size()),
        clipped_(points.size()),
        left_(points.size()) {
    const auto count = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      next_[i] = (i + 1) % count;
      previous_[i] = (i + count - 1) % count;
    }
    // Cutting never makes a convex corner reflex, and an ear that holds any corner holds a reflex or flat
    // one.
    for (std::uint32_t i = 0; i < count; ++i) {
      if (turnAt(i) <= 0) obstacles_.push_back(i);
    }
  }

  // Appends the triangles; false when the work allowed ran out and the rest was cut as it came.
  bool run(std::vector<std::array<std::uint32_t, 3>>& triangles, TriangulationBudget& budget) {
    // Simple polygons of n corners need about n^2 tests, crossing ones up to n^3.
    const std::uint64_t count = points_.size();
    const std::uint64_t allowed = std::min(16 * count * count, budget.testsLeft);
    const auto cut = [&](std::uint32_t corner) {
      triangles.push_back({previous_[corner], corner, next_[corner]});
      next_[previous_[corner]] = next_[corner];
      previous_[next_[corner]] = previous_[corner];
      clipped_[corner] = true;
      --left_;
      // Spikes go before anything else: while one stands, its sides pass for borders of an ear beyond them.
      return isSpike(next_[corner]) ? next_[corner] : previous_[corner];
    };
    std::uint32_t current = 0;
    for (std::size_t passed = 0; passed <= left_ && left_ > 3;) {
      if (isSpike(current)) {
        current = cut(current);
        passed = passed > 0 ? passed - 1 : 0;
      } else {
        current = next_[current];
        ++passed;
      }
    }
    std::size_t refused = 0;
    while (left_ > 3) {
      // When a whole round finds no ear (collinear or crossing corners), a corner is cut off flat, and when a
      // second one finds no flat corner, any: the loop always ends.
      const bool flat = refused >= left_ && turnAt(current) == 0;
      if (tests_ > allowed || refused >= 2 * left_ || flat || isSpike(current) || isEar(current)) {
        current = cut(current);
        refused = 0;
      } else {
        current = next_[current];
        ++refused;
      }
    }
    triangles.push_back({previous_[current], current, next_[current]});
    budget.testsLeft -= std::min(budget.testsLeft, tests_);
    return tests_ <= allowed;
  }

 private:
  double turnAt(std::uint32_t corner) const {
    return turn(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
  }

  // Where the outline turns back on itself or stays in place: bridges to holes end so, once their hole is
  // cut.
  bool isSpike(std::uint32_t corner) const {
    const Point a = points_[previous_[corner]], b = points_[corner], c = points_[next_[corner]];
    return turn(a, b, c) == 0 && (a.x - b.x) * (c.x - b.x) + (a.y - b.y) * (c.y - b.y) >= 0;
  }

  bool isEar(std::uint32_t corner) {
    ++tests_;
    if (turnAt(corner) <= 0) return false;
    const std::uint32_t before = previous_[corner], after = next_[corner];
    const Point a = points_[before], b = points_[corner], c = points_[after];
    for (const std::uint32_t p : obstacles_) {
      ++tests_;
      if (clipped_[p] || p == before || p == corner || p == after) continue;
      const Point point = points_[p];
      const bool blocked = same(point, a)   ? entersBetween(p, b, c)
                           : same(point, b) ? entersBetween(p, c, a)
                           : same(point, c) ? entersBetween(p, a, b)
                                            : inTriangle(point, a, b, c);
      if (blocked) return false;
    }
    return true;
  }

  // Whether the outline at a corner that shares its place with one of an ear runs into the ear, whose sides
  // leave that place towards `from` and `to`. Where it only touches, as bridges do, the ear stands.
  bool entersBetween(std::uint32_t corner, Point from, Point to) const {
    const Point here = points_[corner];
    for (const std::uint32_t neighbour : {previous_[corner], next_[corner]}) {
      if (turn(here, from, points_[neighbour]) > 0 && turn(here, points_[neighbour], to) > 0) return true;
    }
    return false;
  }

  const std::vector<Point>& points_;
  std::vector<std::uint32_t> next_, previous_, obstacles_;
  std::vector<bool> clipped_;
  std::size_t left_;
  std::uint64_t tests_ = 0;
};

}  // namespace

bool triangulate(std::span<const Vec3d> corners, std::vector<std::array<std::uint32_t, 3>>& triangles,
                 TriangulationBudget& budget) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  if (count == 3) {
    triangles.push_back({0, 1, 2});
    return true;
  }
  const std::vector<Point> points = project(corners);
  if (!isStrictlyConvex(points)) return EarClipping(points).run(triangles, budget);
  if (count == 4) {
    // The shorter diagonal makes the better triangles.
    const Vec3d even = corners[2] - corners[0], odd = corners[3] - corners[1];
    if (dot(odd, odd) < dot(even, even)) {
      triangles.insert(triangles.end(), {{1, 2, 3}, {1, 3, 0}});
    } else {
      triangles.insert(triangles.end(), {{0, 1, 2}, {0, 2, 3}});
    }
    return true;
  }
  for (std::uint32_t i = 1; i + 1 < count; ++i) triangles.push_back({0, i, i + 1});
  return true;
}

Vec3d areaDirection(Vec3d a, Vec3d b, Vec3d c) {
  const Vec3d first = b - a, second = c - a;
  const double scale1 = largestDifference(first), scale2 = largestDifference(second);
  if (!(scale1 > 0) || !(scale2 > 0)) return {};
  return cross(first / scale1, second / scale2);
}

}  // namespace shprt
