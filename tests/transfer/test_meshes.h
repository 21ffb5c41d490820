// Meshes that tests can reason about, made in memory.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "shprt/mesh/mesh.h"
#include "shprt/scene/scene.h"

namespace shprt::test {

// A grid of cellsU x cellsV quads over origin + [0,1] u + [0,1] v, with the given normal on all its vertices.
inline void addPatch(Mesh& mesh, Vec3d origin, Vec3d u, Vec3d v, int cellsU, int cellsV, Vec3d normal) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i <= cellsU; ++i)
    for (int j = 0; j <= cellsV; ++j) {
      mesh.positions.push_back(toFloat(origin + u * (double(i) / cellsU) + v * (double(j) / cellsV)));
      mesh.normals.push_back(toFloat(normalize(normal)));
    }
  for (int i = 0; i < cellsU; ++i)
    for (int j = 0; j < cellsV; ++j) {
      const std::uint32_t a = first + static_cast<std::uint32_t>(i * (cellsV + 1) + j),
                          b = a + static_cast<std::uint32_t>(cellsV + 1);
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
}

inline void addPatch(Mesh& mesh, Vec3d origin, Vec3d u, Vec3d v, int cells = 1) {
  addPatch(mesh, origin, u, v, cells, cells, cross(u, v));
}

// A closed box with hard edges: each face has its own vertices. cellsY counts along y, cells along x and z.
inline Mesh makeBox(Vec3d low, Vec3d size, int cells, int cellsY) {
  Mesh mesh;
  const Vec3d x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
  addPatch(mesh, low, y, x, cellsY, cells, {0, 0, -1});
  addPatch(mesh, low, x, z, cells, cells, {0, -1, 0});
  addPatch(mesh, low, z, y, cells, cellsY, {-1, 0, 0});
  addPatch(mesh, low + z, x, y, cells, cellsY, {0, 0, 1});
  addPatch(mesh, low + y, z, x, cells, cells, {0, 1, 0});
  addPatch(mesh, low + x, y, z, cellsY, cells, {1, 0, 0});
  return mesh;
}

inline Mesh makeBox(Vec3d low, Vec3d size, int cells) {
  return makeBox(low, size, cells, cells);
}

// A sphere of unit radius by subdivision of the icosahedron, with the exact normals of the sphere.
inline Mesh makeIcosphere(int subdivisions) {
  const double phi = std::numbers::phi;
  std::vector<Vec3d> points = {{-1, phi, 0}, {1, phi, 0}, {-1, -phi, 0}, {1, -phi, 0},
                               {0, -1, phi}, {0, 1, phi}, {0, -1, -phi}, {0, 1, -phi},
                               {phi, 0, -1}, {phi, 0, 1}, {-phi, 0, -1}, {-phi, 0, 1}};
  std::vector<Triangle> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int step = 0; step < subdivisions; ++step) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
    const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, fresh] =
          midpoints.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(points.size()));
      if (fresh) points.push_back(normalize(normalize(points[a]) + normalize(points[b])));
      return it->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles) {
      const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
  }
  Mesh mesh;
  for (const Vec3d& p : points) {
    mesh.positions.push_back(toFloat(normalize(p)));
    mesh.normals.push_back(toFloat(normalize(p)));
  }
  mesh.triangles = std::move(triangles);
  return mesh;
}

// position * scale + offset, rounded to float as a file would hold it.
inline Mesh moved(Mesh mesh, double scale, Vec3d offset) {
  for (Vec3f& p : mesh.positions) p = toFloat(toDouble(p) * scale + offset);
  return mesh;
}

inline void append(Mesh& mesh, const Mesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
}

inline Scene grey(const Mesh& mesh, float albedo) {
  return makeScene(mesh, std::vector<Vec3f>(mesh.positions.size(), Vec3f{albedo, albedo, albedo}));
}

}  // namespace shprt::test
