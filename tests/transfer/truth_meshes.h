// Scenes whose interreflections are known in closed form, or that are hard on them. Fronts face the light.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "tests/transfer/test_meshes.h"

namespace shprt::test {

inline constexpr Vec3d kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

// The inside of a unit sphere's lower part: `fraction` of its area, cut off level; exact normals. `rings`
// circles of vertices, of which circle i has 6 i, so that triangles keep their shape. The bowl is the convex
// hull of its vertices, so no facet hides the opening from a vertex: what a vertex sees of it is wrong only
// by the sliver between the rim and the circle around it, 1/6 (2 pi / 6 rings)^2 of the opening.
inline Mesh makeBowl(double fraction, int rings) {
  Mesh mesh;
  const double end = std::acos(1 - 2 * fraction);
  const auto vertexOf = [](int ring, int k) {
    return static_cast<std::uint32_t>(ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + k % (6 * ring));
  };
  for (int ring = 0; ring <= rings; ++ring) {
    const double theta = end * ring / rings;
    for (int k = 0; k < std::max(1, 6 * ring); ++k) {
      const double phi = ring == 0 ? 0 : std::numbers::pi * k / (3 * ring);
      const Vec3d p{std::sin(theta) * std::cos(phi), -std::cos(theta), std::sin(theta) * std::sin(phi)};
      mesh.positions.push_back(toFloat(p));
      mesh.normals.push_back(toFloat(-p));
    }
  }
  for (int ring = 0; ring < rings; ++ring)
    for (int sector = 0; sector < 6; ++sector)
      for (int k = 0; k <= ring; ++k) {
        const std::uint32_t inner = vertexOf(ring, sector * ring + k),
                            outer = vertexOf(ring + 1, sector * (ring + 1) + k),
                            next = vertexOf(ring + 1, sector * (ring + 1) + k + 1);
        mesh.triangles.push_back({inner, outer, next});
        if (k < ring) mesh.triangles.push_back({inner, next, vertexOf(ring, sector * ring + k + 1)});
      }
  return mesh;
}

// Faces of a box seen from inside, each a patch of its own.
inline Mesh makeRoom(Vec3d low, Vec3d size, int cells) {
  Mesh mesh = makeBox(low, size, cells);
  for (Vec3f& n : mesh.normals) n = -n;
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

// The room [0,1]^3 with an opening of half its width in the middle of the ceiling. cells: a multiple of 4.
inline Mesh makeRoomWithWindow(int cells) {
  Mesh mesh;
  addPatch(mesh, {}, kZ, kX, cells);
  addPatch(mesh, {}, kY, kZ, cells);
  addPatch(mesh, kX, kZ, kY, cells);
  addPatch(mesh, {}, kX, kY, cells);
  addPatch(mesh, kZ, kY, kX, cells);
  const auto strip = [&](double x, double z, double width, double depth) {
    addPatch(mesh, {x, 1, z}, kX * width, kZ * depth, static_cast<int>(cells * width),
             static_cast<int>(cells * depth), -kY);
  };
  strip(0, 0, 1, 0.25);
  strip(0, 0.75, 1, 0.25);
  strip(0, 0.25, 0.25, 0.5);
  strip(0.75, 0.25, 0.25, 0.5);
  return mesh;
}

// Scenes of several parts, each with a material and an albedo of its own.
class SceneBuilder {
 public:
  SceneBuilder& add(const Mesh& part, Vec3f albedo, Vec3f emission = {}) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    append(mesh_, part);
    albedo_.resize(mesh_.positions.size(), albedo);
    materialsOfVertices_.resize(mesh_.positions.size(), static_cast<std::uint32_t>(materials_.size()));
    materials_.emplace_back();
    materials_.back().name = "part " + std::to_string(materials_.size());
    materials_.back().albedo = albedo;
    materials_.back().emission = emission;
    starts_.push_back(first);
    return *this;
  }
  Scene build() const {
    Scene scene = makeScene(mesh_, albedo_);
    scene.materials = materials_;
    scene.mesh.vertexMaterials = materialsOfVertices_;
    return scene;
  }
  // First vertex of the n-th part that was added.
  std::uint32_t start(std::size_t part) const {
    return part < starts_.size() ? starts_[part] : static_cast<std::uint32_t>(mesh_.positions.size());
  }

 private:
  Mesh mesh_;
  std::vector<Vec3f> albedo_;
  std::vector<SurfaceMaterial> materials_;
  std::vector<std::uint32_t> materialsOfVertices_, starts_;
};

inline Mesh makePatch(Vec3d origin, Vec3d u, Vec3d v, int cells) {
  Mesh mesh;
  addPatch(mesh, origin, u, v, cells);
  return mesh;
}

// After Cornell's: a white room, open in front, with a red and a green wall, a light in the ceiling (a hair
// below it) and a white block that stands on the floor, turned. cells: of each wall.
inline Scene makeCornellBox(int cells) {
  constexpr Vec3f white{0.75f, 0.75f, 0.75f}, red{0.63f, 0.06f, 0.05f}, green{0.15f, 0.48f, 0.09f};
  SceneBuilder builder;
  Mesh whites;
  addPatch(whites, {}, kZ, kX, cells);  // floor
  addPatch(whites, kY, kX, kZ, cells);  // ceiling
  addPatch(whites, {}, kX, kY, cells);  // back
  builder.add(whites, white);
  builder.add(makePatch({}, kY, kZ, cells), red);
  builder.add(makePatch(kX, kZ, kY, cells), green);
  Mesh block = makeBox({-0.15, 0, -0.15}, {0.3, 0.5, 0.3}, std::max(2, cells / 3), std::max(2, cells / 2));
  const double c = std::cos(0.3), s = std::sin(0.3);
  const auto turned = [&](Vec3f p) {
    return toFloat({c * p.x + s * p.z, static_cast<double>(p.y), -s * p.x + c * p.z});
  };
  for (Vec3f& p : block.positions) p = turned(p) + Vec3f{0.5f, 0, 0.45f};
  for (Vec3f& n : block.normals) n = turned(n);
  builder.add(block, white);
  builder.add(makePatch({0.35, 0.98, 0.35}, kX * 0.3, kZ * 0.3, 2), white, {10, 8, 5});
  return builder.build();
}

// Per vertex: a third of the area of the triangles around it.
inline std::vector<double> vertexAreas(const Mesh& mesh) {
  std::vector<double> areas(mesh.positions.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3d p = toDouble(mesh.positions[a]);
    const double area = length(cross(toDouble(mesh.positions[b]) - p, toDouble(mesh.positions[c]) - p)) / 2;
    for (const std::uint32_t corner : {a, b, c}) areas[corner] += area / 3;
  }
  return areas;
}

}  // namespace shprt::test
