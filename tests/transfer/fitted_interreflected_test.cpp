// Fitted bakes of light that bounces, where closed forms or a much finer mesh tell the answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shprt/base/parallel.h"
#include "shprt/transfer/fitted.h"
#include "shprt/transfer/light_solution.h"
#include "shprt/transfer/sample_transfer.h"
#include "shprt/transfer/sent_light.h"
#include "shprt/transfer/transfer_rows.h"
#include "tests/transfer/bounce_settings.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

using test::PatchBeforeWall;

constexpr Vec3d kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

Mesh turnedInsideOut(Mesh mesh) {
  for (Vec3f& normal : mesh.normals) normal = -normal;
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

// A room without a ceiling, red on the left and green on the right, with a white plate that floats in it and
// a lamp that shines down.
struct Room {
  static constexpr int kWalls = 5;
  int cells;  // along each wall
  Scene scene;

  explicit Room(int cellsPerWall) : cells(cellsPerWall) {
    Mesh mesh;
    test::addPatch(mesh, {-1, 0, -1}, kZ * 2, kX * 2, cells);  // floor
    test::addPatch(mesh, {-1, 0, -1}, kY * 2, kZ * 2, cells);  // left
    test::addPatch(mesh, {1, 0, -1}, kZ * 2, kY * 2, cells);   // right
    test::addPatch(mesh, {-1, 0, -1}, kX * 2, kY * 2, cells);  // back
    test::addPatch(mesh, {-1, 0, 1}, kY * 2, kX * 2, cells);   // front
    const std::size_t lamp = mesh.positions.size();
    test::addPatch(mesh, {-0.4, 1.5, -0.4}, kX * 0.5, kZ * 0.5, 2);
    const std::size_t plate = mesh.positions.size();
    test::append(mesh, test::makeBox({-0.2, 0.3, -0.3}, {0.6, 0.1, 0.6}, 4));
    std::vector<Vec3f> albedo(mesh.positions.size(), Vec3f{0.7f, 0.7f, 0.7f});
    const std::size_t wall = verticesPerWall();
    std::fill_n(albedo.begin() + static_cast<std::ptrdiff_t>(wall), wall, Vec3f{0.6f, 0.1f, 0.1f});
    std::fill_n(albedo.begin() + static_cast<std::ptrdiff_t>(2 * wall), wall, Vec3f{0.1f, 0.5f, 0.1f});
    scene = makeScene(mesh, albedo);
    scene.materials.push_back({});
    scene.materials.back().emission = {12, 9, 5};
    for (std::size_t v = lamp; v < plate; ++v) scene.mesh.vertexMaterials[v] = 1;
  }

  std::size_t verticesPerWall() const { return static_cast<std::size_t>((cells + 1) * (cells + 1)); }
  std::size_t vertex(int wall, int i, int j) const {
    return static_cast<std::size_t>(wall) * verticesPerWall() + static_cast<std::size_t>(i * (cells + 1) + j);
  }
  // What interpolation makes of a row of vertex values at fractions (s, t) of a wall, as addPatch cuts it.
  template <class Value>
  auto at(int wall, double s, double t, const Value& value) const {
    const int i = std::min(cells - 1, static_cast<int>(s * cells));
    const int j = std::min(cells - 1, static_cast<int>(t * cells));
    const double u = s * cells - i, v = t * cells - j, far = std::min(u, v);
    const double low = value(vertex(wall, i, j)), high = value(vertex(wall, i + 1, j + 1));
    const double side = u > v ? value(vertex(wall, i + 1, j)) : value(vertex(wall, i, j + 1));
    return low * (1 - std::max(u, v)) + side * std::abs(u - v) + high * far;
  }
};

// RMS distances over the walls of a coarse room's interpolated bake from the bake at a fine one's vertices,
// without those on the walls' borders.
struct Distance {
  double transfer = 0, emission = 0;

  Distance(const Room& coarse, const Bake& bake, const Room& fine, const Bake& truth) {
    int count = 0;
    for (int wall = 0; wall < Room::kWalls; ++wall)
      for (int i = 1; i < fine.cells; ++i)
        for (int j = 1; j < fine.cells; ++j, ++count) {
          const double s = static_cast<double>(i) / fine.cells, t = static_cast<double>(j) / fine.cells;
          const std::size_t vertex = fine.vertex(wall, i, j);
          const auto square = [&](const auto& interpolated, const auto& exact) {
            const double error = coarse.at(wall, s, t, interpolated) - exact(vertex);
            return error * error;
          };
          for (int channel = 0; channel < truth.transfer.channels; ++channel)
            for (int k = 0; k < truth.transfer.rows(); ++k) {
              const auto of = [=](const Bake& from) {
                return [=, &from](std::size_t v) {
                  return static_cast<double>(from.transfer.row(channel, k)[v]);
                };
              };
              transfer += square(of(bake), of(truth));
            }
          const auto green = [](const Bake& from) {
            return [&](std::size_t v) { return static_cast<double>(from.emission[v].y); };
          };
          emission += square(green(bake), green(truth));
        }
    transfer = std::sqrt(transfer / count);
    emission = std::sqrt(emission / count);
  }
};

TEST(FittedInterreflected, CoarseRoomComesNearerToAFineOne) {
  const Room fine(16);
  const InterreflectedOptions options{.degree = 3, .rays = 256, .seed = 1, .error = 0.003};
  const Bake truth = bakeInterreflected(fine.scene, options);
  for (const int cells : {2, 3}) {
    const Room coarse(cells);
    const Distance vertices(coarse, bakeInterreflected(coarse.scene, options), fine, truth);
    const FittedBake bake = bakeFittedInterreflected(coarse.scene, options, {});
    EXPECT_TRUE(bake.fit.converged);
    const Distance fitted(coarse, bake.bake, fine, truth);
    EXPECT_LT(fitted.transfer, 0.9 * vertices.transfer) << cells << " cells";
    EXPECT_LT(fitted.emission, 0.9 * vertices.emission) << cells << " cells";
  }
}

// In a closed room that glows by 1 everywhere, every further bounce adds the next power of the albedo:
// inside a coarse sphere too, where rays leave below the facets that they start from.
TEST(FittedInterreflected, FurnaceIsAGeometricSeries) {
  for (const Mesh& mesh : {test::makeBox({-1, -1, -1}, {2, 2, 2}, 1), test::makeIcosphere(1)}) {
    const Mesh room = turnedInsideOut(mesh);
    const Vec3f albedo{0.5f, 0.25f, 0.75f};
    Scene scene = makeScene(room, std::vector<Vec3f>(room.positions.size(), albedo));
    scene.materials[0].emission = {1, 1, 1};
    for (const int bounces : {0, 1, 3, -1}) {
      InterreflectedOptions options{.degree = 1, .rays = 64, .seed = 1, .error = 1e-4};
      if (bounces >= 0) options.bounces = bounces;
      const FittedBake bake = bakeFittedInterreflected(scene, options, {});
      EXPECT_EQ(bake.buriedSamples, 0u);
      ASSERT_EQ(bake.bake.emission.size(), room.positions.size());
      const auto expected = [&](float rho) {
        const auto ratio = static_cast<double>(rho);
        return (bounces < 0 ? 1 : 1 - std::pow(ratio, bounces + 2)) / (1 - ratio);
      };
      for (const Vec3f& emission : bake.bake.emission) {
        EXPECT_NEAR(emission.x, expected(albedo.x), 1e-3) << bounces;
        EXPECT_NEAR(emission.y, expected(albedo.y), 1e-3) << bounces;
        EXPECT_NEAR(emission.z, expected(albedo.z), 1e-3) << bounces;
      }
      for (const float coefficient : bake.bake.transfer.values) EXPECT_NEAR(coefficient, 0, 1e-6);
    }
  }
}

TEST(FittedInterreflected, ConvexMeshesStayUnshadowed) {
  const Scene scene = test::grey(test::makeIcosphere(1), 0.8f);
  const FittedBake bounced =
      bakeFittedInterreflected(scene, {.degree = 3, .rays = 16, .seed = 1}, {.samples = {.perTriangle = 32}});
  const FittedBake shadowed =
      bakeFitted(scene, {.degree = 3, .rays = 16, .seed = 1}, {.samples = {.perTriangle = 32}});
  EXPECT_EQ(bounced.bake.statistics.meanVisibility, 1);
  EXPECT_TRUE(bounced.bake.emission.empty());
  ASSERT_EQ(bounced.bake.transfer.values.size(), shadowed.bake.transfer.values.size());
  for (std::size_t i = 0; i < shadowed.bake.transfer.values.size(); ++i)
    EXPECT_NEAR(bounced.bake.transfer.values[i], shadowed.bake.transfer.values[i], 1e-6);
}

// A patch receives from a wall that sees nothing but the sky: the wall's share of its hemisphere, times what
// the wall sends back. With the wall's albedo in its vertices or in a texture.
TEST(FittedInterreflected, SamplesReceiveAWallByItsFormFactor) {
  for (const bool textured : {false, true}) {
    PatchBeforeWall setting({0.6f, 0.3f, 0.15f}, {0.5f, 1, 0.25f});
    Scene& scene = setting.scene;
    scene.materials.push_back({});
    scene.materials.back().emission = {3, 2, 1};
    for (std::size_t v = PatchBeforeWall::kPatchVertices; v < scene.albedo.size(); ++v)
      scene.mesh.vertexMaterials[v] = 1;
    if (textured) {
      Image texture;
      texture.width = texture.height = 1;
      texture.pixels = {Vec3f{0.6f, 0.3f, 0.15f}};
      scene.textures.push_back(texture);
      scene.materials.back().texture = 0;
      scene.mesh.textureCoordinates.resize(scene.mesh.positions.size());
      std::fill(scene.albedo.begin() + PatchBeforeWall::kPatchVertices, scene.albedo.end(), Vec3f{1, 0, 1});
    }
    const PreparedScene prepared(scene);
    InterreflectedOptions options{.degree = 2, .rays = 8192, .seed = 1, .bounces = 1};
    const FittedOptions few{.samples = {.perTriangle = 1, .minimum = 4}};
    const FittedBake bake = bakeFittedInterreflected(prepared, options, few);
    options.bounces = 0;  // the same rays
    const FittedBake direct = bakeFittedInterreflected(prepared, options, few);
    std::vector<double> wall(9);
    UnshadowedTransfer(2).evaluate(kX, wall);
    const double share = PatchBeforeWall::formFactor();
    const float patch[3] = {0.5f, 1, 0.25f}, wallAlbedo[3] = {0.6f, 0.3f, 0.15f};
    for (std::size_t vertex = 0; vertex < PatchBeforeWall::kPatchVertices; ++vertex) {
      for (int channel = 0; channel < 3; ++channel)
        for (std::size_t k = 0; k < wall.size(); ++k) {
          const auto i = static_cast<int>(k);
          const double added = static_cast<double>(bake.bake.transfer.row(channel, i)[vertex]) -
                               static_cast<double>(direct.bake.transfer.row(channel, i)[vertex]);
          EXPECT_NEAR(added, static_cast<double>(patch[channel] * wallAlbedo[channel]) * share * wall[k],
                      3e-4);
        }
      EXPECT_NEAR(bake.bake.emission[vertex].x, 0.5 * 3 * share, 3e-3);
      EXPECT_NEAR(bake.bake.emission[vertex].y, 1 * 2 * share, 3e-3);
      EXPECT_NEAR(bake.bake.emission[vertex].z, 0.25 * 1 * share, 3e-3);
    }
  }
}

TEST(FittedInterreflected, BrightLightsDoNotSpoilTheTransfer) {
  Room room(2);
  const InterreflectedOptions options{.degree = 2, .rays = 64, .seed = 1, .bounces = 2};
  const FittedBake dim = bakeFittedInterreflected(room.scene, options, {});
  room.scene.materials.back().emission = Vec3f{12, 9, 5} * 0x1p20f;
  const FittedBake bright = bakeFittedInterreflected(room.scene, options, {});
  EXPECT_EQ(dim.bake.transfer.values, bright.bake.transfer.values);
}

TEST(FittedInterreflected, SameBitsForAnyNumberOfThreadsAndMemory) {
  const Room room(2);
  InterreflectedOptions options{.degree = 2, .rays = 64, .seed = 1, .bounces = 2};
  setThreadCount(1);
  const FittedBake one = bakeFittedInterreflected(room.scene, options, {});
  setThreadCount(0);
  options.hitMemory = 0;
  const FittedBake many = bakeFittedInterreflected(room.scene, options, {});
  EXPECT_EQ(one.bake.transfer.values, many.bake.transfer.values);
  EXPECT_EQ(one.bake.emission, many.bake.emission);
  EXPECT_EQ(one.fit.sampleDistance, many.fit.sampleDistance);
}

TEST(FittedInterreflected, ProgressCountsToTheEndOnce) {
  const Room room(2);
  std::uint64_t last = 0, total = 0;
  const FittedBake bake = bakeFittedInterreflected(room.scene, {.degree = 1, .rays = 32, .seed = 1}, {},
                                                   [&](const ProgressReport& report) {
                                                     EXPECT_GE(report.done, last);
                                                     EXPECT_LE(report.done, report.total);
                                                     last = report.done, total = report.total;
                                                   });
  EXPECT_EQ(last, total);
  EXPECT_GT(total, bake.samples);
}

}  // namespace
}  // namespace shprt
