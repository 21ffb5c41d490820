// Where baking per vertex is prone to black blobs and leaks: borders, contacts, thin walls, buried vertices.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <string>

#include "shprt/transfer/bake.h"
#include "tests/transfer/path_tracer.h"
#include "tests/transfer/truth_meshes.h"

namespace shprt {
namespace {

using std::numbers::pi;
using test::kX, test::kY, test::kZ;

TEST(TruthLeak, BorderOfAnOpenSheetIsLikeItsMiddle) {
  Mesh sheet = test::makePatch({}, kZ, kX, 8);
  for (const bool bothSides : {false, true}) {
    if (bothSides) test::addPatch(sheet, {}, kX, kZ, 8);
    const Scene scene = test::grey(sheet, 0.8f);
    const Bake bake = bakeInterreflected(scene, {.degree = 4, .rays = 64, .seed = 1, .bounces = 3});
    const Bake unshadowed = bakeUnshadowed(scene, 4);
    for (std::size_t i = 0; i < bake.transfer.values.size(); ++i)
      ASSERT_NEAR(bake.transfer.values[i], unshadowed.transfer.values[i], 1e-6) << bothSides << " " << i;
  }
}

// How the floors, ceiling and side walls of two rooms meet the wall between them, a thin box. (Where the same
// vertex serves both rooms, as under a wall without thickness, it cannot be both light and dark.)
enum class Wall {
  kButt,  // they end at its faces
  kSunk   // they go on into it, to a quarter of its thickness
};

struct TwoRooms {
  test::SceneBuilder builder;
  std::size_t firstDarkPart = 0;
};

// Two cubes of width 1 side by side; the left one, at x < 0, has no ceiling. All of the right one and the
// wall's right face are dark.
TwoRooms makeTwoRooms(Wall wall, double thickness, int cells) {
  constexpr Vec3f white{0.9f, 0.9f, 0.9f};
  const double half = thickness / 2, end = wall == Wall::kButt ? half : half / 2;
  TwoRooms rooms;
  const auto side = [&](bool left) {
    const double low = left ? -1 : end, width = 1 - end;
    const Vec3d x = kX * width, corner{low, 0, 0};
    Mesh mesh;
    test::addPatch(mesh, corner, kZ, x, cells);
    test::addPatch(mesh, corner, x, kY, cells);
    test::addPatch(mesh, corner + kZ, kY, x, cells);
    if (left) {
      test::addPatch(mesh, {-1, 0, 0}, kY, kZ, cells);
    } else {
      test::addPatch(mesh, corner + kY, x, kZ, cells);
      test::addPatch(mesh, kX, kZ, kY, cells);
    }
    return mesh;
  };
  rooms.builder.add(side(true), white);
  rooms.builder.add(test::makePatch({-half, 0, 0}, kZ, kY, cells), white);
  Mesh edges;  // of the wall, which nobody sees but the sky above the left room
  test::addPatch(edges, {-half, 1, 0}, kZ, kX * thickness, cells, 1, kY);
  test::addPatch(edges, {-half, 0, 0}, kX * thickness, kZ, 1, cells, -kY);
  rooms.builder.add(edges, white);
  rooms.firstDarkPart = 3;
  rooms.builder.add(test::makePatch({half, 0, 0}, kY, kZ, cells), white);
  rooms.builder.add(side(false), white);
  return rooms;
}

// 1e4 sizes away a float has steps of 1/512 of a room.
constexpr double kCoarse = 0.05;

TEST(TruthLeak, RoomBehindAThinWallStaysDarkToTheLastBit) {
  struct Place {
    double scale, sizesAway, thickness;
  };
  for (const Wall wall : {Wall::kButt, Wall::kSunk})
    for (const Place& place : {Place{1, 0, 1e-6}, {1e-3, 0, 1e-6}, {1e3, 0, 1e-6}, {1, 1e4, kCoarse}}) {
      if (wall == Wall::kSunk && place.sizesAway > 0) continue;  // steps of a float are too coarse for it
      const TwoRooms rooms = makeTwoRooms(wall, place.thickness, 4);
      Scene scene = rooms.builder.build();
      scene.mesh =
          test::moved(scene.mesh, place.scale, Vec3d{1, 0.5, -0.75} * (2 * place.scale * place.sizesAway));
      const Bake bake = bakeInterreflected(scene, {.degree = 1, .rays = 256, .seed = 1, .bounces = 8});
      const std::string where = "wall " + std::to_string(static_cast<int>(wall)) + ", scale " +
                                std::to_string(place.scale) + ", " + std::to_string(place.sizesAway) +
                                " sizes away";
      int lit = 0;
      for (std::size_t v = rooms.builder.start(rooms.firstDarkPart); v < scene.mesh.positions.size(); ++v)
        lit += bake.transfer.row(0, 0)[v] != 0;
      EXPECT_EQ(lit, 0) << where;
      // And the other side is light, up to the wall's foot.
      for (std::size_t v = 0; v < rooms.builder.start(2); ++v)
        ASSERT_GT(bake.transfer.row(0, 0)[v] * std::sqrt(4 * pi), 0.02) << where << ", vertex " << v;
    }
}

// Radiance that leaves the floor at (x, z) under a uniform sky, interpolated as relighting does, and the path
// tracer's.
struct FloorPoint {
  double baked = 0, truth = 0, error = 0;
};

class BoxOnFloor {
 public:
  // The floor is [-1,1]^2 in cells of 1/12. sunk: how deep the box reaches below it.
  BoxOnFloor(double low, double width, double sunk) {
    builder_.add(test::makePatch({-1, 0, -1}, kZ * 2.0, kX * 2.0, 24), {0.8f, 0.8f, 0.8f});
    builder_.add(test::makeBox({low, -sunk, low}, {width, 0.5 + sunk, width}, 6), {0.8f, 0.8f, 0.8f});
    scene_ = builder_.build();
    tracer_ = std::make_unique<test::PathTracer>(scene_);
    bake_ = bakeInterreflected(scene_, {.degree = 1, .rays = 1024, .seed = 1, .bounces = {}, .error = 1e-3});
  }
  double bakedAt(std::size_t vertex) const { return bake_.transfer.row(0, 0)[vertex] * std::sqrt(4 * pi); }
  std::size_t floorVertices() const { return builder_.start(1); }
  const Bake& bake() const { return bake_; }

  FloorPoint at(double x, double z) const {
    for (std::uint32_t t = 0; t < scene_.mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = scene_.mesh.triangles[t];
      if (c >= floorVertices()) break;
      const Vec3d p = toDouble(scene_.mesh.positions[a]), e1 = toDouble(scene_.mesh.positions[b]) - p,
                  e2 = toDouble(scene_.mesh.positions[c]) - p, s = Vec3d{x, 0, z} - p;
      const double determinant = cross(e1, e2).y, u = cross(s, e2).y / determinant,
                   v = cross(e1, s).y / determinant;
      if (u < 0 || v < 0 || u + v > 1) continue;
      const test::PathEstimate estimate =
          tracer_->inTriangle(t, u, v, {.degree = 0, .paths = 4096, .seed = 3});
      const double toRadiance = 0.8 * std::sqrt(4 * pi);
      return {bakedAt(a) * (1 - u - v) + bakedAt(b) * u + bakedAt(c) * v, estimate.transfer[0].x * toRadiance,
              estimate.transferError[0].x * toRadiance};
    }
    ADD_FAILURE() << "no floor at " << x << " " << z;
    return {};
  }

 private:
  test::SceneBuilder builder_;
  Scene scene_;
  std::unique_ptr<test::PathTracer> tracer_;
  Bake bake_;
};

// Just outside the line where a box meets the floor: there a floor that interpolates what its vertices under
// the box have would be dark.
TEST(TruthLeak, NoHaloAroundABoxOnAFloor) {
  struct Case {
    double low, width, sunk;
  };
  for (const Case& c : {Case{-0.25, 0.5, 0}, {-0.25, 0.5, 0.05}, {-0.27, 0.55, 0}, {-0.27, 0.55, 0.05}}) {
    const BoxOnFloor setting(c.low, c.width, c.sunk);
    const std::string where = "box from " + std::to_string(c.low) + ", sunk " + std::to_string(c.sunk);
    double darkest = 0, brightest = 0, sum = 0;  // differences beyond the path tracer's noise
    int points = 0;
    for (const double distance : {0.002, 0.01, 0.03, 0.06})
      for (const double along : {0.1, 0.33, 0.5, 0.77}) {
        const FloorPoint point = setting.at(c.low - distance, c.low + along * c.width);
        const double difference = point.baked - point.truth;
        darkest = std::min(darkest, difference + 3 * point.error);
        brightest = std::max(brightest, difference - 3 * point.error);
        sum += difference;
        ++points;
      }
    const std::string figures = "darker by " + std::to_string(-darkest) + ", brighter by " +
                                std::to_string(brightest) + ", mean " + std::to_string(sum / points) + ", " +
                                std::to_string(setting.bake().statistics.buriedVertices) + " buried";
    // What linear interpolation over a cell loses: of the floor and, where the box is sunk, of its lowest
    // cells as well, whose lower ends are below the floor and see none of its light.
    EXPECT_LT(-darkest, c.sunk > 0 ? 0.05 : 0.03) << where << ": " << figures;
    EXPECT_LT(brightest, 0.06) << where << ": " << figures;
    if (std::getenv("SHPRT_TRUTH_FIGURES")) std::printf("%s: %s\n", where.c_str(), figures.c_str());
  }
}

}  // namespace
}  // namespace shprt
