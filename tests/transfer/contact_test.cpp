// Floor vertices on the line where a box stands: half of the triangles around them are inside it, and the
// other half is what everyone sees.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shprt/transfer/bake.h"
#include "tests/transfer/bounce_settings.h"
#include "tests/transfer/path_tracer.h"
#include "tests/transfer/truth_meshes.h"

namespace shprt {
namespace {

using test::kX, test::kY, test::kZ;

constexpr int kCells = 16;  // of the floor [-1,1]^2, along each side
constexpr double kCell = 2.0 / kCells;

// How a box stands on the floor: the square over `corner` and along `side`, in cells of the floor.
struct Stand {
  const char* name;
  int corner[2], side[2];
  int cells;  // of the box's faces, along each side
};

constexpr Stand kStands[] = {
    {"along grid lines, sharing vertices", {-2, -2}, {4, 0}, 4},
    {"along grid lines, between the box's vertices", {-3, -2}, {5, 0}, 3},
    {"along diagonals of cells, and against them", {0, -3}, {3, 3}, 2},
    {"across cells", {-1, -3}, {4, 2}, 3},
};

class BoxOnGrid {
 public:
  explicit BoxOnGrid(const Stand& stand) : stand_(stand) {
    Mesh mesh = test::makePatch({-1, 0, -1}, kZ * 2.0, kX * 2.0, kCells);
    floorVertices_ = static_cast<std::uint32_t>(mesh.positions.size());
    const Vec3d corner = Vec3d{double(stand.corner[0]), 0, double(stand.corner[1])} * kCell;
    const Vec3d u = Vec3d{double(stand.side[0]), 0, double(stand.side[1])} * kCell;
    const Vec3d v{-u.z, 0, u.x}, up = kY * 0.5;
    const int n = stand.cells;
    test::addPatch(mesh, corner, u, up, n, n, -v);
    test::addPatch(mesh, corner + v, up, u, n, n, v);
    test::addPatch(mesh, corner, up, v, n, n, -u);
    test::addPatch(mesh, corner + u, v, up, n, n, u);
    test::addPatch(mesh, corner, u, v, n, n, -kY);
    test::addPatch(mesh, corner + up, v, u, n, n, kY);
    scene_ = test::grey(mesh, 0.8f);
  }
  const Scene& scene() const { return scene_; }
  std::uint32_t floorVertices() const { return floorVertices_; }

  // Where a floor vertex lies, exactly: along the box's two sides, from 0 to `end` where it is under the box.
  struct Place {
    int along, across, end;

    bool isInside() const { return along > 0 && along < end && across > 0 && across < end; }
    bool isCorner() const { return along % end == 0 && across % end == 0; }
    bool isOnLine() const {
      return along >= 0 && along <= end && across >= 0 && across <= end && !isInside();
    }
  };
  Place placeOf(std::uint32_t vertex) const {
    const Vec3f p = scene_.mesh.positions[vertex];
    const int x = static_cast<int>(std::lround(double(p.x) / kCell)) - stand_.corner[0],
              z = static_cast<int>(std::lround(double(p.z) / kCell)) - stand_.corner[1];
    const auto& [a, b] = stand_.side;
    return {x * a + z * b, z * a - x * b, a * a + b * b};
  }
  // Of a vertex on the line and not at a corner: the unit vector along the floor away from the box.
  Vec3d outwards(std::uint32_t vertex) const {
    const Place place = placeOf(vertex);
    const Vec3d u = normalize(Vec3d{double(stand_.side[0]), 0, double(stand_.side[1])}), v{-u.z, 0, u.x};
    if (place.along % place.end == 0) return place.along == 0 ? -u : u;
    return place.across == 0 ? -v : v;
  }
  std::vector<std::uint32_t> onLine() const {
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 0; v < floorVertices_; ++v)
      if (placeOf(v).isOnLine()) vertices.push_back(v);
    return vertices;
  }

 private:
  Stand stand_;
  Scene scene_;
  std::uint32_t floorVertices_ = 0;
};

// Right at the foot of a wall, it hides what lies behind its plane: half of a uniform sky. At a box's corner
// it depends on which side of it one stands: between half and a quarter.
TEST(Contact, FootOfAWallSeesHalfTheSky) {
  for (const Stand& stand : kStands) {
    const BoxOnGrid box(stand);
    const Bake bake = bakeShadowed(box.scene(), {.degree = 0, .rays = 1024, .seed = 1});
    const std::vector<std::uint32_t> vertices = box.onLine();
    EXPECT_GE(vertices.size(), 8u) << stand.name;
    for (const std::uint32_t v : vertices) {
      const double seen = test::uniformLight(bake, v) / 0.8;
      const BoxOnGrid::Place place = box.placeOf(v);
      if (place.isCorner()) {
        EXPECT_GT(seen, 0.49) << stand.name << ", corner, vertex " << v;
        EXPECT_LT(seen, 0.76) << stand.name << ", corner, vertex " << v;
      } else {
        EXPECT_NEAR(seen, 0.5, 0.01) << stand.name << ", vertex " << v;
      }
    }
    for (std::uint32_t v = 0; v < box.floorVertices(); ++v) {
      if (!box.placeOf(v).isInside()) continue;
      // Buried: as its surroundings.
      EXPECT_GT(test::uniformLight(bake, v) / 0.8, 0.45) << stand.name << ", inside, vertex " << v;
      EXPECT_LT(test::uniformLight(bake, v) / 0.8, 0.76) << stand.name << ", inside, vertex " << v;
    }
  }
}

TEST(Contact, OnlyWhatIsUnderTheBoxIsBuried) {
  for (const Stand& stand : kStands) {
    const BoxOnGrid box(stand);
    const InterreflectedOptions options{.degree = 1, .rays = 256, .seed = 1, .bounces = 0};
    const Bake bake = bakeInterreflected(box.scene(), options);
    std::uint64_t inside = 0;
    for (std::uint32_t v = 0; v < box.floorVertices(); ++v) inside += box.placeOf(v).isInside();
    EXPECT_EQ(bake.statistics.buriedVertices, inside) << stand.name;
    // Elsewhere both models trace the same rays from the same step.
    const Bake shadowed = bakeShadowed(box.scene(), {.degree = 1, .rays = 256, .seed = 1});
    for (const std::uint32_t v : box.onLine())
      for (int i = 0; i < 4; ++i)
        EXPECT_FLOAT_EQ(bake.transfer.row(0, i)[v], shadowed.transfer.row(0, i)[v]) << stand.name << " " << v;
  }
}

// What the path tracer finds at a point of the floor.
test::PathEstimate traceFloor(const BoxOnGrid& box, const test::PathTracer& tracer, Vec3d point) {
  const Mesh& mesh = box.scene().mesh;
  for (std::uint32_t t = 0; t < 2 * kCells * kCells; ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3d p = toDouble(mesh.positions[a]), e1 = toDouble(mesh.positions[b]) - p,
                e2 = toDouble(mesh.positions[c]) - p, s = point - p;
    const double determinant = cross(e1, e2).y, u = cross(s, e2).y / determinant,
                 v = cross(e1, s).y / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1)
      return tracer.inTriangle(t, u, v, {.degree = 0, .paths = 4096, .seed = 5});
  }
  ADD_FAILURE() << "no floor at " << point.x << " " << point.z;
  return {.transfer = {{}}, .transferError = {{}}, .emission = {}, .emissionError = {}};
}

TEST(Contact, AllBouncesAgreeWithThePathTracerJustOutside) {
  for (const Stand& stand : kStands) {
    const BoxOnGrid box(stand);
    const Bake bake =
        bakeInterreflected(box.scene(), {.degree = 0, .rays = 1024, .seed = 1, .bounces = {}, .error = 1e-3});
    const test::PathTracer tracer(box.scene());
    for (const std::uint32_t v : box.onLine()) {
      if (box.placeOf(v).isCorner()) continue;
      const Vec3d outside = toDouble(box.scene().mesh.positions[v]) + box.outwards(v) * (1e-3 * kCell);
      const test::PathEstimate truth = traceFloor(box, tracer, outside);
      const double toRadiance = 0.8 * std::sqrt(4 * std::numbers::pi);
      // Beyond the noise: what interpolation over the wall's lowest cell loses.
      const double tolerance = 3 * truth.transferError[0].x * toRadiance + 0.03;
      EXPECT_NEAR(test::uniformLight(bake, v), truth.transfer[0].x * toRadiance, tolerance)
          << stand.name << ", vertex " << v;
    }
  }
}

// A floor and a wall behind it, and two boxes on each other in front of the wall: rays from what they cover
// meet fronts too, of the floor and of the lower box. None of it may be dark, as light would fade towards it.
TEST(Contact, WhatStackedBoxesCoverIsBuried) {
  for (const int cells : {4, 5}) {  // of the upper box; the lower one has 4
    Mesh mesh = test::makePatch({-1, 0, 0}, kZ, kX * 2.0, 12);
    test::addPatch(mesh, {-1, 0, 0}, kX * 2.0, kY, 12);
    const auto covered = static_cast<std::uint32_t>(mesh.positions.size());
    test::append(mesh, test::makeBox({-0.45, 0, 0}, {0.9, 0.4, 0.6}, 4));
    test::append(mesh, test::makeBox({-0.45, 0.4, 0}, {0.9, 0.4, 0.6}, cells));
    const Bake bake = bakeInterreflected(test::grey(mesh, 0.8f), {.degree = 0, .rays = 256, .seed = 1});
    int inside = 0;
    for (std::uint32_t v = 0; v < covered; ++v) {
      const Vec3f p = mesh.positions[v];
      inside += std::abs(p.x) < 0.45f && p.y < 0.8f && p.z < 0.6f;
      EXPECT_GT(test::uniformLight(bake, v), 0.2) << cells << " cells: " << p.x << " " << p.y << " " << p.z;
    }
    EXPECT_GE(bake.statistics.buriedVertices, static_cast<std::uint64_t>(inside)) << cells;
  }
}

// A lamp without a back hides most of the ceiling above it, in a room without sky. That is no solid: its
// light reaches the ceiling beside it, and what the lamp shades stays in its shade.
TEST(Contact, CeilingAboveALampIsNotBuried) {
  test::SceneBuilder builder;
  builder.add(test::makeRoom({}, {1, 1, 1}, 12), {0.8f, 0.8f, 0.8f});
  builder.add(test::makePatch({0.3, 0.9, 0.3}, kX * 0.4, kZ * 0.4, 2), {0.8f, 0.8f, 0.8f}, {1, 1, 1});
  const Bake bake = bakeInterreflected(builder.build(), {.degree = 0, .rays = 256, .seed = 1, .bounces = 1});
  EXPECT_EQ(bake.statistics.buriedVertices, 0u);
}

}  // namespace
}  // namespace shprt
