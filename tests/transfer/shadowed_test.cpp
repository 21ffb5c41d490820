// Shadowed transfer where it is known exactly, in closed form, or by symmetry.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/bake.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

constexpr Vec3d kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

// Cosine-weighted visible share of each vertex: the first coefficient over that of a surface that sees
// everything.
double visibleShare(const Bake& bake, std::size_t vertex) {
  return static_cast<double>(bake.transfer.row(0, 0)[vertex]) * std::sqrt(4 * std::numbers::pi);
}

void expectExactlyUnshadowed(const Mesh& mesh, const std::string& what) {
  const Scene scene = test::grey(mesh, 0.8f);
  const Bake shadowed = bakeShadowed(scene, {.degree = 4, .rays = 64, .seed = 3});
  const Bake unshadowed = bakeUnshadowed(scene, 4);
  EXPECT_EQ(shadowed.transfer.values, unshadowed.transfer.values) << what;
  EXPECT_EQ(shadowed.statistics.fullyVisible, mesh.positions.size()) << what;
}

TEST(Shadowed, ConvexClosedMeshesAreExactlyUnshadowedAtAnySizeAndPlace) {
  for (const double scale : {1e-4, 1.0, 1e6})
    for (const double away : {0.0, 1e5}) {
      const Vec3d offset = Vec3d{1, -0.5, 0.75} * (away * scale);
      const std::string where =
          "scale " + std::to_string(scale) + ", " + std::to_string(away) + " sizes away";
      expectExactlyUnshadowed(test::moved(test::makeBox({-1, -1, -1}, {2, 2, 2}, 4), scale, offset),
                              "box, " + where);
      for (int subdivisions = 0; subdivisions < 3; ++subdivisions) {
        // So far away a float mesh has steps of 1/128 of its size: a fine sphere is no longer convex there.
        if (away > 0 && subdivisions > 1) continue;
        expectExactlyUnshadowed(test::moved(test::makeIcosphere(subdivisions), scale, offset),
                                "icosphere " + std::to_string(subdivisions) + ", " + where);
      }
    }
}

TEST(Shadowed, ThinThingsAndOpenBordersAreClean) {
  expectExactlyUnshadowed(test::makeBox({0, 0, 0}, {1, 1e-6, 1}, 8, 1), "thin box");
  Mesh sheet;
  test::addPatch(sheet, {0, 0, 0}, kZ, kX, 8);
  expectExactlyUnshadowed(sheet, "open sheet");
  test::addPatch(sheet, {0, 0, 0}, kX, kZ, 8);
  expectExactlyUnshadowed(sheet, "both sides of a sheet");
}

TEST(Shadowed, CoarseSmoothBoxDoesNotShadowItself) {
  // Eight vertices whose normals point along the diagonals: the worst a smooth normal can be off.
  Mesh box = test::makeBox({-1, -1, -1}, {2, 2, 2}, 1);
  for (std::size_t v = 0; v < box.positions.size(); ++v)
    box.normals[v] = toFloat(normalize(toDouble(box.positions[v])));
  expectExactlyUnshadowed(box, "smooth box");
}

// A floor point at the foot of a wall, joined to it or only touching it, keeps exactly half of its
// cosine-weighted sky, and T_lm is the integral over that quarter sphere.
TEST(Shadowed, FloorAtTheFootOfAWallSeesAQuarterSphere) {
  for (const bool touchingOnly : {false, true}) {
    Mesh corner;
    test::addPatch(corner, {0, 0, -1}, kZ * 2.0, kX, 2);
    test::addPatch(corner, {0, touchingOnly ? -0.7 : 0.0, -1}, kY * 2.0, kZ * 2.0, 2);
    const int degree = 4, rays = 4096;
    const Bake bake = bakeShadowed(test::grey(corner, 1), {.degree = degree, .rays = rays, .seed = 1});
    const std::size_t vertex = 3;
    ASSERT_EQ(corner.positions[vertex], (Vec3f{0, 0, 0}));
    std::vector<double> expected(static_cast<std::size_t>(coefficientCount(degree))), y(expected.size());
    const int side = 512;  // midpoints over u and half of v
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        const double u = (i + 0.5) / side, phi = std::numbers::pi * ((j + 0.5) / side - 0.5);
        evaluateSh(degree, {std::sqrt(u) * std::cos(phi), std::sqrt(1 - u), std::sqrt(u) * std::sin(phi)}, y);
        for (std::size_t k = 0; k < y.size(); ++k) expected[k] += 0.5 * y[k] / (side * side);
      }
    EXPECT_NEAR(visibleShare(bake, vertex), 0.5, 2e-3);
    for (std::size_t k = 0; k < y.size(); ++k) {
      EXPECT_NEAR(bake.transfer.row(0, static_cast<int>(k))[vertex], expected[k], 2e-3)
          << "coefficient " << k;
    }
  }
}

// A disc of radius R at height h over a floor point hides exactly R^2/(R^2+h^2) of its cosine-weighted sky,
// and T_l0 about the upright axis is 2 * integral of t P_l(t) over cosines t below h/sqrt(R^2+h^2).
TEST(Shadowed, DiscAboveAPlane) {
  const int sides = 256, degree = 6;
  const double height = 0.75, polygonRadius = 1, step = 2 * std::numbers::pi / sides;
  // The radius of the disc that has the polygon's area.
  const double radius = polygonRadius * std::sqrt(std::sin(step) / step);
  Mesh mesh;
  test::addPatch(mesh, {-2, 0, -2}, kZ * 4.0, kX * 4.0, 2);
  const auto centre = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back({0, static_cast<float>(height), 0});
  for (int k = 0; k < sides; ++k) {
    mesh.positions.push_back(
        toFloat({polygonRadius * std::cos(k * step), height, polygonRadius * std::sin(k * step)}));
    const auto a = centre + 1 + static_cast<std::uint32_t>(k),
               b = centre + 1 + static_cast<std::uint32_t>((k + 1) % sides);
    mesh.triangles.push_back({centre, a, b});
  }
  mesh.normals.resize(mesh.positions.size(), {0, -1, 0});
  const std::size_t vertex = 4;
  ASSERT_EQ(mesh.positions[vertex], (Vec3f{0, 0, 0}));

  const double cosine = height / std::hypot(height, radius);
  std::vector<double> zonal;  // 2 * integral_0^cosine t P_l(t) dt, by Simpson's rule
  for (int l = 0; l <= degree; ++l) {
    const int n = 2000;
    double sum = 0;
    for (int i = 0; i <= n; ++i) {
      const double t = cosine * i / n;
      sum += t * std::legendre(static_cast<unsigned>(l), t) * (i == 0 || i == n ? 1 : i % 2 ? 4 : 2);
    }
    zonal.push_back(2 * sum * cosine / n / 3);
  }
  const Bake bake = bakeShadowed(test::grey(mesh, 1), {.degree = degree, .rays = 16384, .seed = 2});
  EXPECT_NEAR(visibleShare(bake, vertex), height * height / (height * height + radius * radius), 1e-3);
  std::vector<double> y(static_cast<std::size_t>(coefficientCount(degree)));
  evaluateSh(degree, kY, y);
  for (int l = 0; l <= degree; ++l)
    for (int m = -l; m <= l; ++m) {
      const auto k = static_cast<std::size_t>(shIndex(l, m));
      EXPECT_NEAR(bake.transfer.row(0, shIndex(l, m))[vertex], zonal[static_cast<std::size_t>(l)] * y[k],
                  2e-3)
          << l << " " << m;
    }
}

// A closed box around everything hides everything, and its inside walls see only each other.
TEST(Shadowed, InsideOfAClosedBoxIsExactlyBlack) {
  Mesh room = test::makeBox({-2, -2, -2}, {4, 4, 4}, 2);
  for (Vec3f& n : room.normals) n = -n;
  for (Triangle& t : room.triangles) std::swap(t[1], t[2]);
  test::append(room, test::makeIcosphere(1));
  const Bake bake = bakeShadowed(test::grey(room, 1), {.degree = 3, .rays = 256, .seed = 1});
  for (const float value : bake.transfer.values) ASSERT_EQ(value, 0);
  EXPECT_EQ(bake.statistics.fullyHidden, room.positions.size());
  EXPECT_EQ(bake.statistics.meanVisibility, 0);
}

// Rays from below a sheet that only meets the floor in a groove must not slip out under it.
TEST(Shadowed, GrooveOfAnOpenTerrainLeaksNoLight) {
  const double a = 40 * std::numbers::pi / 180;
  Mesh mesh;
  test::addPatch(mesh, {0, 0, -1e4}, kZ * 2e4, Vec3d{std::cos(a), std::sin(a), 0}, 2, 2, kY);
  test::addPatch(mesh, {0, 0, -1e4}, Vec3d{-std::cos(a), std::sin(a), 0}, kZ * 2e4, 2, 2, kY);
  const Bake bake = bakeShadowed(test::grey(mesh, 1), {.degree = 2, .rays = 4096, .seed = 1});
  // Between two long walls that rise at angle a the cosine-weighted visible share is cos a.
  EXPECT_NEAR(visibleShare(bake, 3), std::cos(a), 2e-3);
}

TEST(Shadowed, BitsDependOnTheSeedAndNotOnTheThreads) {
  Mesh mesh = test::makeIcosphere(3);
  test::append(mesh, test::moved(test::makeIcosphere(3), 0.7, {1.2, 0.9, 0}));
  const Scene scene = test::grey(mesh, 0.7f);
  setThreadCount(1);
  const Bake one = bakeShadowed(scene, {.degree = 4, .rays = 100, .seed = 11});
  setThreadCount(2);
  const Bake two = bakeShadowed(scene, {.degree = 4, .rays = 100, .seed = 11});
  setThreadCount(0);
  const Bake other = bakeShadowed(scene, {.degree = 4, .rays = 100, .seed = 12});
  EXPECT_EQ(one.transfer.values, two.transfer.values);
  EXPECT_NE(one.transfer.values, other.transfer.values);
}

// Seam vertices that differ only in texture coordinate or material get the same transfer, per unit albedo.
TEST(Shadowed, SeamsDoNotShow) {
  Mesh mesh = test::makeIcosphere(2);
  test::append(mesh, test::moved(test::makeIcosphere(1), 0.5, {1.3, 0.4, 0}));
  const std::size_t count = mesh.positions.size();
  mesh.positions.push_back(mesh.positions[7]);
  mesh.normals.push_back(mesh.normals[7]);
  for (std::size_t t = 0; t < 40; ++t)
    for (std::uint32_t& corner : mesh.triangles[t]) {
      if (corner == 7) corner = static_cast<std::uint32_t>(count);
    }
  const Bake bake = bakeShadowed(test::grey(mesh, 1), {.degree = 4, .rays = 128, .seed = 1});
  for (int i = 0; i < bake.transfer.rows(); ++i)
    EXPECT_EQ(bake.transfer.row(0, i)[7], bake.transfer.row(0, i)[count]);
  EXPECT_EQ(bake.statistics.samplePoints, count);
}

TEST(Shadowed, ReportsProgressToTheEnd) {
  const Mesh mesh = test::makeIcosphere(3);
  std::uint64_t last = 0, total = 0, rays = 0;
  bakeShadowed(test::grey(mesh, 1), {.degree = 2, .rays = 16, .seed = 1}, [&](const ProgressReport& report) {
    EXPECT_GE(report.done, last);
    last = report.done;
    total = report.total;
    rays = report.rays;
  });
  EXPECT_EQ(last, mesh.positions.size());
  EXPECT_EQ(total, mesh.positions.size());
  EXPECT_EQ(rays, 16 * mesh.positions.size());
}

}  // namespace
}  // namespace shprt
