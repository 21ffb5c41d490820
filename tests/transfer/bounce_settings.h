// Settings in which bounced light is known in closed form.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shprt/transfer/bake.h"
#include "tests/transfer/test_meshes.h"

namespace shprt::test {

// Irradiance/pi under a uniform sky of radiance 1, times albedo.
inline double uniformLight(const Bake& bake, std::size_t vertex, int channel = 0) {
  return static_cast<double>(bake.transfer.row(channel, 0)[vertex]) * std::sqrt(4 * std::numbers::pi);
}

// The part of the unit sphere below height top, lit from inside; pole at the bottom.
inline Mesh makeBowlBelow(double top, int rings, int sides) {
  Mesh mesh;
  const double end = std::acos(-top);  // polar angle from the bottom
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < sides; ++j) {
      const double polar = end * i / rings, azimuth = 2 * std::numbers::pi * j / sides;
      const Vec3d p{std::sin(polar) * std::cos(azimuth), -std::cos(polar),
                    std::sin(polar) * std::sin(azimuth)};
      mesh.positions.push_back(i == 0 ? Vec3f{0, -1, 0} : toFloat(p));
      mesh.normals.push_back(-mesh.positions.back());
    }
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < sides; ++j) {
      const auto at = [&](int ring, int side) {
        return static_cast<std::uint32_t>(ring * sides + side % sides);
      };
      if (i > 0) mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  return mesh;
}

// A patch so small that it disturbs nothing, on the floor before a wall of 2 x 1 with normal +x at x = 0.
struct PatchBeforeWall {
  static constexpr double kDistance = 0.5;
  static constexpr std::size_t kPatchVertices = 4;
  Scene scene;

  explicit PatchBeforeWall(Vec3f wallAlbedo, Vec3f patchAlbedo = {1, 1, 1}) {
    Mesh mesh;
    const double size = 1e-3;
    addPatch(mesh, {kDistance, 0, 0}, {0, 0, size}, {size, 0, 0});
    addPatch(mesh, {0, 0, -1}, {0, 1, 0}, {0, 0, 2}, 4);
    std::vector<Vec3f> albedo(mesh.positions.size(), wallAlbedo);
    std::fill_n(albedo.begin(), kPatchVertices, patchAlbedo);
    scene = makeScene(mesh, albedo);
  }
  // Share of the patch's cosine-weighted hemisphere that the wall takes between two heights, by midpoints.
  static double formFactor(double low = 0, double high = 1) {
    const int side = 1000;
    double sum = 0;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        const double y = low + (high - low) * (i + 0.5) / side, z = -1 + 2 * (j + 0.5) / side;
        const double square = kDistance * kDistance + y * y + z * z;
        sum += y * kDistance / (std::numbers::pi * square * square) * 2 * (high - low) / (side * side);
      }
    return sum;
  }
};

}  // namespace shprt::test
