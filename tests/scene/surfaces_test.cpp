// Where albedo comes from: vertex colours, textures and their colour spaces, and which goes before which.
#include <cmath>

#include "shprt/image/image.h"
#include "shprt/scene/texture.h"
#include "tests/scene/scene_files.h"

namespace shprt {
namespace {

using test::hasNote;
using test::loadText;
using test::oneObject;

void expectNear(Vec3f a, Vec3f b, float tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

// Of the curve's definition, in double.
float srgbToLinear(double value) {
  return static_cast<float>(value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
}

void writePicture(const std::string& name, Vec3f left, Vec3f right) {
  saveImage(test::scratch(name), Image{2, 1, {left, right}});
}

// A triangle whose corners lie on the middles of the left, right and left pixel of a 2 x 1 picture, with
// colours.
void writeMesh(const std::string& name, bool mapped, const std::string& texture, const std::string& colour) {
  test::writeScratch(name + ".mtl", "newmtl paint\nKd 0.5 0.25 0.75\n" +
                                        (texture.empty() ? "" : "map_Kd " + texture + "\n"));
  std::string obj = "mtllib " + name + ".mtl\nusemtl paint\n";
  for (const char* place : {"0 0 0", "1 0 0", "0 1 0"})
    obj += std::string("v ") + place + " " + colour + "\n";
  obj += "vt 0.25 0.5\nvt 0.75 0.5\n";
  test::writeScratch(name + ".obj", obj + (mapped ? "f 1/1 2/2 3/1\n" : "f 1 2 3\n"));
}

const Vec3f kPaint{0.5f, 0.25f, 0.75f};

TEST(Surfaces, TexturesGoBeforeColoursBeforeMaterials) {
  writePicture("t.exr", {0.5f, 0.25f, 0.125f}, {1, 0, 0.0625f});
  writeMesh("m", true, "t.exr", "0 1 0");
  const Scene textured = loadText(oneObject(""));
  ASSERT_EQ(textured.textures.size(), 1u);
  EXPECT_EQ(textured.albedo,
            (std::vector<Vec3f>{{0.5f, 0.25f, 0.125f}, {1, 0, 0.0625f}, {0.5f, 0.25f, 0.125f}}));
  EXPECT_EQ(textured.albedoSources.textures, 3u);
  // Inside the triangle the picture is asked, not the corners.
  expectNear(textured.albedoAt(0, 0.5f, 0), {0.75f, 0.125f, 0.09375f}, 1e-6f);
  EXPECT_EQ(textured.sources.size(), 4u);

  writeMesh("m", true, "", "0 1 0");
  const Scene coloured = loadText(oneObject(""));
  EXPECT_EQ(coloured.albedo, std::vector<Vec3f>(3, Vec3f{0, 1, 0}));
  EXPECT_EQ(coloured.albedoSources.vertexColours, 3u);
  EXPECT_TRUE(hasNote(coloured, "vertex colours taken as linear"));
  EXPECT_EQ(loadText(oneObject(R"("material": {"vertexColors": "ignore"})")).albedo,
            std::vector<Vec3f>(3, kPaint));
}

TEST(Surfaces, TheSceneFileGoesBeforeTheMeshFile) {
  writePicture("t.exr", {0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f});
  writePicture("own.exr", {0.125f, 0, 1}, {0.125f, 0, 1});
  writeMesh("m", true, "t.exr", "0 1 0");
  const Scene albedo = loadText(oneObject(R"("material": {"albedo": 0.25})"));
  EXPECT_EQ(albedo.albedo, std::vector<Vec3f>(3, Vec3f{0.25f, 0.25f, 0.25f}));
  EXPECT_TRUE(albedo.textures.empty());
  EXPECT_EQ(albedo.albedoAt(0, 0.25f, 0.25f), (Vec3f{0.25f, 0.25f, 0.25f}));
  const Scene texture = loadText(oneObject(R"("material": {"texture": "own.exr"})"));
  EXPECT_EQ(texture.albedo, std::vector<Vec3f>(3, Vec3f{0.125f, 0, 1}));
  ASSERT_EQ(texture.textures.size(), 1u);
  // The object's texture replaces the albedo that the material's name has.
  const Scene both = loadText(R"({"objects": [{"file": "m.obj", "material": {"texture": "own.exr"}}],
                                  "materials": {"paint": {"albedo": 1}}})");
  EXPECT_EQ(both.albedo, texture.albedo);
}

TEST(Surfaces, EachPictureIsReadOnce) {
  writePicture("t.exr", {0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f});
  writeMesh("m", true, "t.exr", "");
  writeMesh("n", true, "./t.exr", "");
  const Scene scene = loadText(R"({"objects": [{"file": "m.obj"}, {"file": "n.obj"},
      {"file": "m.obj", "material": {"texture": "t.exr"}}, {"file": "m.obj", "material": {"textureColorSpace": "srgb"}}]})");
  ASSERT_EQ(scene.textures.size(), 2u);
  EXPECT_EQ(scene.sources.size(), 6u);
  EXPECT_EQ(scene.materials[0].texture, scene.materials[1].texture);
  EXPECT_EQ(scene.materials[0].texture, scene.materials[2].texture);
  EXPECT_EQ(scene.albedo[0].x, 0.5f);
  EXPECT_NEAR(scene.albedo[9].x, srgbToLinear(0.5), 1e-6f);
}

TEST(Surfaces, PicturesOfIntegersAreSrgbUnlessSaidOtherwise) {
  writePicture("t.png", {51 / 255.0f, 1, 0}, {1, 1, 1});
  writeMesh("m", true, "t.png", "");
  expectNear(loadText(oneObject("")).albedo[0], {srgbToLinear(0.2), 1, 0}, 1e-6f);
  expectNear(loadText(oneObject(R"("material": {"textureColorSpace": "srgb"})")).albedo[0],
             {srgbToLinear(0.2), 1, 0}, 1e-6f);
  expectNear(loadText(oneObject(R"("material": {"textureColorSpace": "linear"})")).albedo[0], {0.2f, 1, 0},
             1e-6f);
}

TEST(Surfaces, PicturesOfOtherMachinesAreSoughtBesideTheMaterial) {
  writePicture("t.exr", {0.5f, 0.25f, 0}, {1, 0.5f, 0});
  for (const char* name : {R"(C:\models\t.exr)", "/none/such/t.exr", R"(.\t.exr)"}) {
    writeMesh("m", true, name, "");
    EXPECT_EQ(loadText(oneObject("")).albedo[0], (Vec3f{0.5f, 0.25f, 0})) << name;
  }
}

TEST(Surfaces, PicturesAreClamped) {
  writePicture("t.exr", {4, -1, NAN}, {1, 0.5f, 0});
  writeMesh("m", true, "t.exr", "");
  const Scene scene = loadText(oneObject(""));
  EXPECT_EQ(scene.albedo[0], (Vec3f{1, 0, 0}));
  EXPECT_EQ(scene.textures[0].at(1, 0), (Vec3f{1, 0.5f, 0}));
  EXPECT_TRUE(hasNote(scene, "t.exr: 1 pixels clamped to [0,1]"));
}

TEST(Surfaces, ColoursAreDecodedAsTheirTypeOrTheSceneFileSays) {
  writeMesh("fractions", false, "", "0.5 0 1");
  writeMesh("bytes", false, "", "51 0 255");
  const auto albedo = [](const char* file, const char* colours) {
    return loadText(std::string(R"({"objects": [{"file": ")") + file + R"(.obj", "material": {)" + colours +
                    "}}]}")
        .albedo[0];
  };
  EXPECT_EQ(albedo("fractions", ""), (Vec3f{0.5f, 0, 1}));
  expectNear(albedo("bytes", ""), {srgbToLinear(0.2), 0, 1}, 1e-6f);
  expectNear(albedo("fractions", R"("vertexColors": "srgb")"), {srgbToLinear(0.5), 0, 1}, 1e-6f);
  EXPECT_EQ(albedo("bytes", R"("vertexColors": "linear")"), (Vec3f{0.2f, 0, 1}));
}

TEST(Surfaces, VerticesWithoutColourHaveTheirMaterials) {
  test::writeScratch("m.mtl", "newmtl paint\nKd 0.5 0.25 0.75\n");
  test::writeScratch("m.obj", "mtllib m.mtl\nusemtl paint\nv 0 0 0 0 0.5 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Scene scene = loadText(oneObject(""));
  EXPECT_EQ(scene.albedo, (std::vector<Vec3f>{{0, 0.5f, 1}, kPaint, kPaint}));
  EXPECT_EQ(scene.albedoSources.vertexColours, 1u);
  EXPECT_EQ(scene.albedoSources.materials, 2u);
}

TEST(Surfaces, MissingTexturesOfMeshFilesAreNoted) {
  test::writeScratch("broken.png", "\x89PNG\r\n\x1a\n and no more");
  test::writeScratch("m.mtl",
                     "newmtl a\nKd 0.5 0.25 0.75\nmap_Kd none.png\nnewmtl b\nmap_Kd broken.png\n"
                     "newmtl c\nKd 0.5 0.25 0.75\nmap_Kd none.png\n");
  test::writeScratch("m.obj",
                     "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n"
                     "usemtl b\nf 1/1 2/1 3/1\nusemtl c\nf 1/1 2/1 3/1\n");
  const Scene scene = loadText(oneObject(""));
  EXPECT_TRUE(hasNote(scene, "2 textures of materials cannot be read, done without"));
  EXPECT_TRUE(hasNote(scene, "none.png"));
  EXPECT_EQ(scene.albedo[0], kPaint);
  EXPECT_EQ(scene.albedo[3], (Vec3f{0.8f, 0.8f, 0.8f}));
  EXPECT_EQ(scene.albedoSources.defaulted, 3u);

  writePicture("t.exr", {0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f});
  writeMesh("m", false, "t.exr", "");
  const Scene unmapped = loadText(oneObject(""));
  EXPECT_TRUE(hasNote(unmapped, "textures of 1 material ignored: the mesh has no texture coordinates"));
  EXPECT_EQ(unmapped.albedo[0], kPaint);
}

TEST(Surfaces, MissingTexturesOfSceneFilesAreRefused) {
  writeMesh("m", true, "", "");
  const std::string error = test::errorOf(oneObject(R"("material": {"texture": "none.png"})"));
  EXPECT_NE(error.find("objects[0].material.texture is wrong: "), std::string::npos) << error;
  EXPECT_NE(error.find("none.png"), std::string::npos);
}

// At every vertex, the picture's pixel is the albedo; the picture is asked directly.
void expectTextured(const Scene& scene, const std::filesystem::path& picture) {
  const Image image = loadImage(picture).image;
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.albedoSources.textures, scene.mesh.positions.size());
  float least = 1, most = 0;
  for (std::size_t v = 0; v < scene.mesh.positions.size(); ++v) {
    const Vec3f expected = sampleTexture(image, scene.mesh.textureCoordinates[v]);
    ASSERT_EQ(scene.albedo[v], expected);
    least = std::min(least, expected.y), most = std::max(most, expected.y);
  }
  EXPECT_LT(least, most);
}

TEST(SharedScenes, FuzeHasTheTextureOfItsMaterial) {
  const std::filesystem::path folder = SHPRT_SHARED_DIR "/data/meshes/fuze";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "SKIPPED: no " << folder;
  const Scene scene = loadScene(folder / "fuze.obj");
  expectTextured(scene, folder / "fuze uv.jpg");
  EXPECT_TRUE(hasNote(scene, "Ks of 1 material ignored"));
}

TEST(SharedScenes, SpotHasTheTextureOfItsSceneFile) {
  const std::filesystem::path folder = SHPRT_SHARED_DIR "/data/meshes";
  if (!std::filesystem::exists(folder / "spot.obj")) GTEST_SKIP() << "SKIPPED: no " << folder;
  const std::string base = folder.string();
  expectTextured(loadText(R"({"objects": [{"file": ")" + base + R"(/spot.obj", "material": {"texture": ")" +
                          base + R"(/spot_texture.png"}}]})"),
                 folder / "spot_texture.png");
}

TEST(SharedScenes, VertexColoursBecomeAlbedo) {
  const std::filesystem::path folder = SHPRT_SHARED_DIR "/data/meshes";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "SKIPPED: no " << folder;
  const Scene cube = loadScene(folder / "cube-vertexcol.obj"),
              plane = loadScene(folder / "colored_airplane.ply"),
              bunny = loadScene(folder / "bunny_attribute_color.ply");
  for (const Scene* scene : {&cube, &plane, &bunny})
    EXPECT_EQ(scene->albedoSources.vertexColours, scene->mesh.positions.size());
  EXPECT_TRUE(hasNote(plane, "vertex colours taken as sRGB"));
  EXPECT_TRUE(hasNote(bunny, "vertex colours taken as linear"));
}

}  // namespace
}  // namespace shprt
