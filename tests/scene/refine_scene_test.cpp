// What a scene's vertices carry follows them when its mesh is refined.
#include <gtest/gtest.h>

#include "shprt/scene/refine_scene.h"
#include "shprt/scene/texture.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

// A receiving and a blocking sheet that share an edge, of two materials; the first is textured.
Scene twoSheets() {
  Mesh mesh;
  test::addPatch(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  test::addPatch(mesh, {1, 0, 0}, {1, 0, 0}, {0, 1, 0});
  for (const Vec3f& p : mesh.positions) mesh.textureCoordinates.push_back({p.x, p.y});
  Scene scene = makeScene(mesh, std::vector<Vec3f>(8, Vec3f{0.25f, 0.5f, 0.75f}));
  scene.albedo[6] = {0.75f, 0.5f, 0.25f};  // the blocker's corner (2, 0)
  scene.objects.resize(2);
  scene.objects[1].role = Role::kBlocker;
  scene.materials.resize(2);
  scene.materials[0].texture = 0;
  Image image;
  image.width = image.height = 4;
  for (int i = 0; i < 16; ++i) image.pixels.push_back({static_cast<float>(i) / 16, 0.5f, 0.25f});
  scene.textures = {image};
  for (std::size_t v = 4; v < 8; ++v) scene.vertexObjects[v] = scene.mesh.vertexMaterials[v] = 1;
  return scene;
}

TEST(RefineScene, AlbedoComesFromTheTextureOrFromTheParents) {
  const Scene coarse = twoSheets();
  const RefinedScene refined = splitLongEdges(coarse, 0.3, RefinedObjects::kAll);
  const Scene& scene = refined.scene;
  ASSERT_EQ(scene.albedo.size(), scene.mesh.positions.size());
  ASSERT_GT(scene.albedo.size(), 8u + 30u);
  for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(scene.albedo[v], coarse.albedo[v]) << "an original vertex";
  for (std::size_t v = 8; v < scene.albedo.size(); ++v) {
    if (scene.mesh.vertexMaterials[v] == 0) {
      EXPECT_EQ(scene.albedo[v], sampleTexture(scene.textures[0], scene.mesh.textureCoordinates[v]));
    } else {
      const auto [a, b] = refined.vertexParents[v - 8];
      EXPECT_EQ(scene.albedo[v], toFloat((toDouble(scene.albedo[a]) + toDouble(scene.albedo[b])) * 0.5));
    }
  }
}

TEST(RefineScene, ObjectsAndMaterialsFollowTheirTriangles) {
  const Scene coarse = twoSheets();
  for (const RefinedObjects objects : {RefinedObjects::kReceivers, RefinedObjects::kAll}) {
    const RefinedScene refined = splitLongEdges(coarse, 0.2, objects);
    const Scene& scene = refined.scene;
    ASSERT_EQ(scene.vertexObjects.size(), scene.mesh.positions.size());
    int blockers = 0;
    for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t) {
      const Triangle& parent = coarse.mesh.triangles[refined.triangleParents[t]];
      for (const std::uint32_t v : scene.mesh.triangles[t]) {
        EXPECT_EQ(scene.vertexObjects[v], coarse.vertexObjects[parent[0]]);
        EXPECT_EQ(scene.mesh.vertexMaterials[v], coarse.mesh.vertexMaterials[parent[0]]);
      }
      blockers += scene.isReceiver(scene.mesh.triangles[t][0]) ? 0 : 1;
    }
    if (objects == RefinedObjects::kAll) {
      EXPECT_GE(blockers, 64);
    } else {
      EXPECT_GT(blockers, 2) << "the shared edge is split on both sides";
      EXPECT_LT(blockers, 32);
    }
  }
}

TEST(RefineScene, WorksWithoutTextureCoordinates) {
  Scene scene = twoSheets();
  scene.mesh.textureCoordinates.clear();
  const RefinedScene refined = splitLongEdges(scene, 0.5, RefinedObjects::kAll);
  for (std::size_t v = 8; v < refined.scene.albedo.size(); ++v)
    EXPECT_EQ(refined.scene.albedo[v].y, 0.5f) << "all parents have it";
}

}  // namespace
}  // namespace shprt
