#include "shprt/scene/scene.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "shprt/scene/texture.h"

namespace shprt {

bool Scene::emits() const {
  return std::any_of(mesh.vertexMaterials.begin(), mesh.vertexMaterials.end(),
                     [&](std::uint32_t material) { return materials[material].emission != Vec3f{}; });
}

Vec3f Scene::albedoAt(std::uint32_t triangle, float u, float v) const {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const float w = 1 - u - v;
  const SurfaceMaterial& material = materialOf(triangle);
  if (!material.texture || mesh.textureCoordinates.empty())
    return albedo[a] * w + albedo[b] * u + albedo[c] * v;
  const Vec2f p = mesh.textureCoordinates[a], q = mesh.textureCoordinates[b], r = mesh.textureCoordinates[c];
  return sampleTexture(textures[*material.texture],
                       {p.x * w + q.x * u + r.x * v, p.y * w + q.y * u + r.y * v});
}

void makeGrey(Scene& scene) {
  const auto mean = [](Vec3f& colour) {
    const float grey = (colour.x + colour.y + colour.z) / 3;
    colour = {grey, grey, grey};
  };
  std::for_each(scene.albedo.begin(), scene.albedo.end(), mean);
  for (Image& texture : scene.textures) std::for_each(texture.pixels.begin(), texture.pixels.end(), mean);
}

Scene makeScene(Mesh mesh, std::vector<Vec3f> albedo) {
  assert(albedo.size() == mesh.positions.size());
  Scene scene;
  scene.mesh = std::move(mesh);
  scene.albedo = std::move(albedo);
  scene.mesh.vertexMaterials.assign(scene.mesh.positions.size(), 0);
  scene.mesh.materials.clear();
  scene.mesh.colours.clear();
  scene.vertexObjects.assign(scene.mesh.positions.size(), 0);
  scene.objects.emplace_back();
  scene.objects.back().report = scene.mesh.report;
  scene.materials.emplace_back();
  scene.albedoSources.asked = scene.albedo.size();
  return scene;
}

}  // namespace shprt
