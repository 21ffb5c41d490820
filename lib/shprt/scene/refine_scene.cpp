#include "shprt/scene/refine_scene.h"

#include <cassert>
#include <cstddef>
#include <utility>

#include "shprt/scene/texture.h"

namespace shprt {

std::vector<bool> trianglesToRefine(const Scene& scene, RefinedObjects objects) {
  std::vector<bool> wanted(scene.mesh.triangles.size());
  for (std::size_t t = 0; t < wanted.size(); ++t)
    wanted[t] = objects == RefinedObjects::kAll || scene.isReceiver(scene.mesh.triangles[t][0]);
  return wanted;
}

Scene onSubdivision(Scene scene, Subdivision&& subdivision) {
  assert(subdivision.mesh.positions.size() == scene.mesh.positions.size() + subdivision.vertexParents.size());
  scene.mesh = std::move(subdivision.mesh);
  const Mesh& mesh = scene.mesh;
  for (const auto& [a, b] : subdivision.vertexParents) {
    const std::size_t vertex = scene.albedo.size();
    const SurfaceMaterial& material = scene.materials[mesh.vertexMaterials[vertex]];
    scene.albedo.push_back(
        material.texture && !mesh.textureCoordinates.empty()
            ? sampleTexture(scene.textures[*material.texture], mesh.textureCoordinates[vertex])
            : toFloat((toDouble(scene.albedo[a]) + toDouble(scene.albedo[b])) * 0.5));
    scene.vertexObjects.push_back(scene.vertexObjects[a]);
  }
  return scene;
}

RefinedScene splitLongEdges(Scene scene, double maxEdge, RefinedObjects objects, std::uint64_t maxTriangles) {
  Subdivision subdivision =
      splitLongEdges(scene.mesh, maxEdge, trianglesToRefine(scene, objects), maxTriangles);
  RefinedScene refined;
  refined.vertexParents = subdivision.vertexParents;
  refined.triangleParents = std::move(subdivision.triangleParents);
  refined.scene = onSubdivision(std::move(scene), std::move(subdivision));
  return refined;
}

}  // namespace shprt
