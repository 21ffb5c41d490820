#include "shprt/scene/back_sides.h"

#include <algorithm>
#include <limits>

#include "shprt/base/error.h"

namespace shprt {

void addBackSides(Scene& scene) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  Mesh& mesh = scene.mesh;
  if (std::none_of(scene.materials.begin(), scene.materials.end(),
                   [](const SurfaceMaterial& material) { return material.twoSided; }))
    return;
  if (std::max(mesh.positions.size(), 3 * mesh.triangles.size()) > kNone / 2)
    throw Error("scene", "has more vertices or triangles on both sides than 32-bit indices can name",
                "make fewer materials two-sided");
  std::vector<std::uint32_t> backs(mesh.positions.size(), kNone);
  const auto backOf = [&](std::uint32_t vertex) {
    if (backs[vertex] != kNone) return backs[vertex];
    backs[vertex] = static_cast<std::uint32_t>(mesh.positions.size());
    const auto repeat = [vertex](auto& perVertex) {
      const auto value = perVertex[vertex];
      perVertex.push_back(value);
    };
    repeat(mesh.positions);
    mesh.normals.push_back(-mesh.normals[vertex]);
    if (!mesh.textureCoordinates.empty()) repeat(mesh.textureCoordinates);
    repeat(mesh.vertexMaterials);
    repeat(scene.albedo);
    repeat(scene.vertexObjects);
    return backs[vertex];
  };
  const std::size_t fronts = mesh.triangles.size();
  for (std::uint32_t triangle = 0; triangle < fronts; ++triangle) {
    if (!scene.materialOf(triangle).twoSided) continue;
    const auto [a, b, c] = mesh.triangles[triangle];
    const std::uint32_t backA = backOf(a), backC = backOf(c), backB = backOf(b);
    mesh.triangles.push_back({backA, backC, backB});
  }
}

}  // namespace shprt
