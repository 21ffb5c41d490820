// Scene files: every field, every refusal, and how objects come together.
#include "shprt/scene/load_scene.h"

#include <algorithm>

#include "shprt/mesh/load_mesh.h"
#include "tests/scene/scene_files.h"

namespace shprt {
namespace {

using test::errorOf;
using test::hasNote;
using test::loadText;
using test::oneObject;

TEST(LoadScene, AMeshFileIsASceneOfOneReceiver) {
  const std::string path = test::writeScratch("plain.obj", test::triangleObj() + "curv 1 2\n");
  const Scene scene = loadScene(path);
  const Mesh mesh = loadMesh(path).mesh;
  EXPECT_EQ(scene.mesh.positions, mesh.positions);
  EXPECT_EQ(scene.mesh.normals, mesh.normals);
  EXPECT_EQ(scene.mesh.triangles, mesh.triangles);
  EXPECT_EQ(scene.notes, mesh.report.notes);
  EXPECT_EQ(scene.mesh.report.notes, mesh.report.notes);
  EXPECT_TRUE(scene.mesh.materials.empty());
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.objects[0].name, "plain");
  EXPECT_EQ(scene.objects[0].file, path);
  EXPECT_TRUE(scene.isReceiver(0));
  EXPECT_EQ(scene.sources, (std::vector<std::filesystem::path>{path}));
  EXPECT_EQ(scene.albedo, std::vector<Vec3f>(3, Vec3f{0.8f, 0.8f, 0.8f}));
  EXPECT_EQ(scene.albedoSources.defaulted, 3u);
  EXPECT_FALSE(scene.emits());
}

TEST(LoadScene, ObjectsComeTogetherInOrder) {
  test::writeScratch("a.obj", test::triangleObj());
  test::writeScratch("b.obj", "v 0 0 5\nv 1 0 5\nv 0 1 5\nvt 0.5 0.25\nf 1/1 2/1 3/1\nf 1/1 3/1 2/1\n");
  const Scene scene = loadText(R"({"$schema": "x", "objects": [{"file": "a.obj", "name": "floor"},
      {"file": "b.obj", "role": "blocker"}, {"file": "a.obj", "role": "receiver", "transform": {"translate": [0, 0, 9]}},
      {"file": "./a.obj"}]})");
  ASSERT_EQ(scene.objects.size(), 4u);
  EXPECT_EQ(scene.objects[0].name, "floor");
  EXPECT_EQ(scene.objects[1].name, "b");
  EXPECT_EQ(scene.objects[2].name, "a");
  EXPECT_EQ(scene.objects[3].name, "a-2");
  EXPECT_EQ(scene.objects[3].file, "./a.obj");
  EXPECT_EQ(scene.objects[1].role, Role::kBlocker);
  EXPECT_EQ(scene.objects[1].report.sourceFaces, 2u);
  EXPECT_EQ(scene.mesh.positions.size(), 15u);
  EXPECT_EQ(scene.mesh.triangles.size(), 5u);
  EXPECT_EQ(scene.mesh.report.sourceFaces, 5u);
  EXPECT_EQ(scene.vertexObjects, (std::vector<std::uint32_t>{0, 0, 0, 1, 1, 1, 1, 1, 1, 2, 2, 2, 3, 3, 3}));
  EXPECT_FALSE(scene.isReceiver(3));
  EXPECT_TRUE(scene.isReceiver(9));
  const float heights[] = {0, 5, 9, 0};
  for (const Triangle& triangle : scene.mesh.triangles)
    for (const std::uint32_t vertex : triangle) {
      EXPECT_EQ(scene.vertexObjects[vertex], scene.vertexObjects[triangle[0]]);
      EXPECT_EQ(scene.mesh.positions[vertex].z, heights[scene.vertexObjects[vertex]]);
    }
  ASSERT_EQ(scene.mesh.textureCoordinates.size(), 15u);
  EXPECT_EQ(scene.mesh.textureCoordinates[4], (Vec2f{0.5f, 0.25f}));
  EXPECT_EQ(scene.mesh.textureCoordinates[0], (Vec2f{}));
  ASSERT_EQ(scene.sources.size(), 3u);  // each once, whichever way it is spelled
  EXPECT_EQ(scene.sources[0].filename(), "scene.json");
  EXPECT_EQ(scene.sources[1].filename(), "a.obj");
  EXPECT_EQ(scene.sources[2].filename(), "b.obj");
  for (const std::uint32_t material : scene.mesh.vertexMaterials) EXPECT_LT(material, scene.materials.size());
}

TEST(LoadScene, CreaseAnglesOfObjectsGoBeforeTheGeneralOne) {
  // Two triangles that meet at 90 degrees: smooth above that angle, hard below.
  test::writeScratch("m.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 2 1 4\n");
  EXPECT_EQ(loadText(oneObject("")).mesh.positions.size(), 6u);
  EXPECT_EQ(loadText(oneObject(R"("creaseAngle": 100)")).mesh.positions.size(), 4u);
  EXPECT_EQ(loadText(oneObject(""), {.creaseAngleDegrees = 100}).mesh.positions.size(), 4u);
  EXPECT_EQ(loadText(oneObject(R"("creaseAngle": 10)"), {.creaseAngleDegrees = 100}).mesh.positions.size(),
            6u);
}

TEST(LoadScene, MaterialsKeepEveryField) {
  test::writeScratch("m.mtl", "newmtl glass\nKd 0.5 0.25 0.125\nKe 1 2 3\nnewmtl wax\nKd 1 1 1\n");
  test::writeScratch("m.obj",
                     "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl glass\nf 1 2 3\nusemtl wax\nf 3 2 1\n");
  const Scene plain = loadText(oneObject(""));
  ASSERT_EQ(plain.materials.size(), 2u);
  EXPECT_EQ(plain.materials[0].albedo, (Vec3f{0.5f, 0.25f, 0.125f}));
  EXPECT_EQ(plain.materials[0].emission, (Vec3f{1, 2, 3}));
  EXPECT_TRUE(plain.emits());
  EXPECT_TRUE(hasNote(plain, "1 material of mesh files with emission"));
  EXPECT_EQ(plain.albedoSources.materials, 6u);
  EXPECT_EQ(plain.albedo[0], plain.materials[0].albedo);

  const Scene scene =
      loadText(R"({"objects": [{"file": "m.obj", "material": {"emission": [4, 5, 6], "twoSided": true}}],
      "materials": {"glass": {"albedo": 0.25, "emission": 9, "glossy": {"reflectance": 0.5, "roughness": 0.125}},
                    "wax": {"albedo": [0.1, 0.2, 0.3], "twoSided": false,
                            "translucent": {"transmittance": [0.5, 0.25, 0], "meanFreePath": 2}}}})");
  ASSERT_EQ(scene.materials.size(), 2u);
  const SurfaceMaterial &glass = scene.materials[0], &wax = scene.materials[1];
  EXPECT_EQ(glass.name, "glass");
  EXPECT_EQ(glass.albedo, (Vec3f{0.25f, 0.25f, 0.25f}));
  EXPECT_EQ(glass.emission, (Vec3f{4, 5, 6}));  // the object's goes before the material's
  ASSERT_TRUE(glass.gloss.has_value());
  EXPECT_EQ(glass.gloss->reflectance, (Vec3f{0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(glass.gloss->roughness, 0.125f);
  EXPECT_FALSE(glass.translucency.has_value());
  EXPECT_EQ(wax.albedo, (Vec3f{0.1f, 0.2f, 0.3f}));
  EXPECT_TRUE(wax.twoSided);
  ASSERT_TRUE(wax.translucency.has_value());
  EXPECT_EQ(wax.translucency->transmittance, (Vec3f{0.5f, 0.25f, 0}));
  EXPECT_EQ(wax.translucency->meanFreePath, 2);
  EXPECT_EQ(scene.albedoSources.sceneFile, 6u);
  EXPECT_TRUE(hasNote(scene, "glossy reflection of 1 material recorded, not simulated"));
  EXPECT_TRUE(hasNote(scene, "translucency of 1 material recorded, not simulated"));
}

TEST(LoadScene, OptionsOverrideEverything) {
  test::writeScratch("m.obj", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n");
  const Scene scene = loadText(oneObject(R"("material": {"albedo": 0.5, "twoSided": false})"),
                               {.albedo = Vec3f{0.1f, 0.2f, 0.3f}, .twoSided = true});
  EXPECT_EQ(scene.albedo, std::vector<Vec3f>(6, Vec3f{0.1f, 0.2f, 0.3f}));
  EXPECT_EQ(scene.mesh.triangles.size(), 2u);
  EXPECT_EQ(scene.albedoSources.asked, 3u);
}

TEST(LoadScene, BothSidesHaveTheirOwnVertices) {
  test::writeScratch("m.obj",
                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n"
                     "f 1/1 2/2 3/3\nf 3/3 2/2 4/4\n");
  const Scene scene = loadText(R"({"objects": [{"file": "m.obj"}, {"file": "m.obj", "role": "blocker",
      "transform": {"translate": [0, 0, 3]}, "material": {"twoSided": true, "albedo": 0.5, "emission": 2}}]})");
  const Mesh& mesh = scene.mesh;
  ASSERT_EQ(mesh.positions.size(), 12u);
  ASSERT_EQ(mesh.triangles.size(), 6u);
  EXPECT_EQ(mesh.textureCoordinates.size(), 12u);
  EXPECT_EQ(scene.albedo.size(), 12u);
  for (std::uint32_t triangle = 4; triangle < 6; ++triangle) {
    const Triangle front = mesh.triangles[triangle - 2], back = mesh.triangles[triangle];
    EXPECT_TRUE(scene.materialOf(triangle).twoSided);
    for (const std::uint32_t vertex : back) {
      EXPECT_GE(vertex, 8u);
      EXPECT_EQ(mesh.normals[vertex], (Vec3f{0, 0, -1}));
      EXPECT_EQ(scene.albedo[vertex], (Vec3f{0.5f, 0.5f, 0.5f}));
      EXPECT_EQ(scene.vertexObjects[vertex], 1u);
      EXPECT_EQ(scene.materials[mesh.vertexMaterials[vertex]].emission, (Vec3f{2, 2, 2}));
      // One of the front's corners, with all that it has.
      EXPECT_TRUE(std::any_of(front.begin(), front.end(), [&](std::uint32_t other) {
        return mesh.positions[other] == mesh.positions[vertex] &&
               mesh.textureCoordinates[other] == mesh.textureCoordinates[vertex];
      }));
    }
    const Vec3d a = toDouble(mesh.positions[back[0]]), b = toDouble(mesh.positions[back[1]]),
                c = toDouble(mesh.positions[back[2]]);
    EXPECT_LT(cross(b - a, c - a).z, 0);
  }
}

TEST(LoadScene, KnowsSceneFiles) {
  EXPECT_TRUE(
      isSceneFile(test::writeScratch("a.json", R"({"$schema": "x", "materials": {}, "objects": []})")));
  EXPECT_FALSE(isSceneFile(test::writeScratch("b.json", R"({"lights": [{"objects": 1}]})")));
  EXPECT_FALSE(isSceneFile(test::writeScratch("c.json", R"({"materials": {"objects": []}})")));
  EXPECT_FALSE(isSceneFile(test::writeScratch("d.obj", test::triangleObj())));
  EXPECT_FALSE(isSceneFile(test::scratch("missing.json")));
}

TEST(LoadScene, RefusesByName) {
  test::writeScratch("m.obj", test::triangleObj());
  test::writeScratch("empty.obj", "v 0 0 0\n");
  const auto material = [](const char* fields) { return oneObject(std::string("\"material\": ") + fields); };
  for (const auto& [json, problem] : std::initializer_list<std::pair<std::string, const char*>>{
           {"{", "is not valid JSON at line 1"},
           {"{}", ": objects is missing"},
           {R"({"objects": 1})", ": objects is no list"},
           {R"({"objects": []})", ": objects is empty"},
           {R"({"objects": [1]})", ": objects[0] is no object"},
           {R"({"objects": [{"file": "m.obj"}], "lights": []})", ": lights is not known here"},
           {R"({"$schema": 1, "objects": [{"file": "m.obj"}]})", ": $schema is no text"},
           {R"({"objects": [{"file": "m.obj"}, {"name": "x"}]})", ": objects[1].file is missing"},
           {R"({"objects": [{"file": ""}]})", ": objects[0].file is empty"},
           {R"({"objects": [{"file": 3}]})", ": objects[0].file is no text"},
           {R"({"objects": [{"file": "n.obj"}]})", "n.obj, which does not exist"},
           {R"({"objects": [{"file": "empty.obj"}]})", ": objects[0].file is wrong: "},
           {oneObject(R"("role": "light")"), ": objects[0].role 'light' is not known"},
           {oneObject(R"("role": "blocker")"), ": objects are all blockers"},
           {oneObject(R"("name": "")"), ": objects[0].name cannot be part of a file's name"},
           {oneObject(R"("name": "a/b")"), ": objects[0].name cannot be part of a file's name"},
           {oneObject(R"("creaseAngle": 181)"), ": objects[0].creaseAngle is not in 0 to 180"},
           {oneObject(R"("colour": 1)"), ": objects[0].colour is not known here"},
           {R"({"objects": [{"file": "m.obj", "name": "x"}, {"file": "m.obj", "name": "x"}]})",
            ": objects[1].name 'x' is given to another object too"},
           {material("1"), ": objects[0].material is no object"},
           {material(R"({"color": 1})"), ": objects[0].material.color is not known here"},
           {material(R"({"albedo": 1.5})"), ": objects[0].material.albedo is above 1"},
           {material(R"({"albedo": [0, -0.5, 0]})"), ": objects[0].material.albedo is negative"},
           {material(R"({"albedo": "red"})"), ": objects[0].material.albedo is neither a number nor a list"},
           {material(R"({"albedo": [1, 1]})"), ": objects[0].material.albedo does not have three numbers"},
           {material(R"({"albedo": 1, "texture": "t.png"})"),
            ": objects[0].material.albedo is given beside a texture"},
           {material(R"({"texture": 1})"), ": objects[0].material.texture is no text"},
           {material(R"({"texture": "t.png"})"),
            ": objects[0].material.texture is given, but the mesh has no"},
           {material(R"({"textureColorSpace": "aces"})"),
            ": objects[0].material.textureColorSpace 'aces' is not known"},
           {material(R"({"vertexColors": "no"})"), ": objects[0].material.vertexColors 'no' is not known"},
           {material(R"({"twoSided": 1})"), ": objects[0].material.twoSided is neither true nor false"},
           {material(R"({"emission": -1})"), ": objects[0].material.emission is negative"},
           {material(R"({"emission": 1e39})"), ": objects[0].material.emission is beyond the range of float"},
           {material(R"({"glossy": 1})"), ": objects[0].material.glossy is no object"},
           {material(R"({"glossy": {"reflectance": 2, "roughness": 0}})"),
            ": objects[0].material.glossy.reflectance is above 1"},
           {material(R"({"glossy": {"reflectance": 1}})"),
            ": objects[0].material.glossy.roughness is missing"},
           {material(R"({"translucent": {"transmittance": 1, "meanFreePath": -1}})"),
            ": objects[0].material.translucent.meanFreePath is negative"},
           {R"({"objects": [{"file": "m.obj"}], "materials": []})", ": materials is no object"},
           {R"({"objects": [{"file": "m.obj"}], "materials": {"": {"albedo": 2}}})",
            ": materials..albedo is above 1"},
           {R"({"objects": [{"file": "m.obj"}], "materials": {"tin": {}}})",
            ": materials.tin is the name of no mesh's material"}})
    EXPECT_NE(errorOf(json).find(problem), std::string::npos) << json << "\n" << errorOf(json);
}

TEST(LoadScene, DamagedFilesAreRefusedInOneLine) {
  test::writeScratch("m.obj", test::triangleObj());
  const std::string whole =
      R"({"objects": [{"name": "n", "file": "m.obj", "role": "receiver", "creaseAngle": 30,
      "transform": {"scale": [1, 2, 3], "rotate": {"axis": [0, 1, 0], "degrees": 20}, "translate": [1, 2, 3]},
      "material": {"albedo": [0.5, 0.5, 0.5], "twoSided": true, "emission": 2}}], "materials": {"": {"albedo": 1}}})";
  EXPECT_EQ(loadText(whole).mesh.triangles.size(), 2u);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    const std::string cut = errorOf(whole.substr(0, at));
    EXPECT_FALSE(cut.empty()) << at;
    EXPECT_EQ(cut.find('\n'), std::string::npos);
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x13);
    EXPECT_EQ(errorOf(flipped).find('\n'), std::string::npos);  // or it loads
  }
}

TEST(LoadScene, LoadsTheCornellBox) {
  const Scene scene = loadScene(SHPRT_SOURCE_DIR "/data/cornell.json");
  ASSERT_EQ(scene.objects.size(), 4u);
  EXPECT_EQ(scene.objects[2].name, "short-box");
  EXPECT_TRUE(scene.emits());
  EXPECT_TRUE(scene.notes.empty()) << scene.notes[0];
  EXPECT_EQ(scene.albedoSources.materials, scene.mesh.positions.size());
  std::uintmax_t bytes = 0;
  for (const std::filesystem::path& source : scene.sources) bytes += std::filesystem::file_size(source);
  EXPECT_LT(bytes, 300'000u);
  EXPECT_EQ(scene.sources.size(), 5u);
  for (const Vec3f& p : scene.mesh.positions) {
    EXPECT_LE(std::max(std::abs(p.x), std::abs(p.z)), 1);
    EXPECT_GE(p.y, 0);
    EXPECT_LE(p.y, 2);
  }
  // All that shines is the panel, and it looks down.
  for (std::size_t v = 0; v < scene.mesh.positions.size(); ++v) {
    const bool shines = scene.materials[scene.mesh.vertexMaterials[v]].emission != Vec3f{};
    EXPECT_EQ(shines, scene.objects[scene.vertexObjects[v]].name == "panel");
    if (shines) {
      EXPECT_EQ(scene.mesh.normals[v], (Vec3f{0, -1, 0}));
    }
  }
}

}  // namespace
}  // namespace shprt
