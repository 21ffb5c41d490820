// Placing meshes: positions, normals and winding under transforms whose effect can be worked out by hand.
#include "shprt/scene/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/scene/scene_files.h"

namespace shprt {
namespace {

using test::errorOf;
using test::loadText;
using test::oneObject;

Mat3 diagonal(double x, double y, double z) {
  return {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}};
}

// A slanted triangle with its own normal at each corner.
Mesh slanted() {
  Mesh mesh;
  mesh.positions = {{1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  mesh.normals.assign(3, toFloat(normalize({1, 1 / 2.0, 1 / 3.0})));
  mesh.textureCoordinates = {{0, 0}, {1, 0}, {0, 1}};
  mesh.vertexMaterials = {0, 0, 0};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

Vec3d windingNormal(const Mesh& mesh) {
  const auto& [a, b, c] = mesh.triangles[0];
  const Vec3d p = toDouble(mesh.positions[a]), q = toDouble(mesh.positions[b]),
              r = toDouble(mesh.positions[c]);
  return normalize(cross((q - p) / length(q - p), (r - p) / length(r - p)));
}

void expectNear(Vec3d a, Vec3d b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Transform, KeepsNormalsPerpendicularAndWindingAgreeing) {
  const Mat3 turn = rotationAbout({1, 2, 3}, 77);
  for (const Mat3& linear :
       {diagonal(1, 1, 1), diagonal(-1, 1, 1), diagonal(-2, -3, -0.25), diagonal(1, 4, 0.125), turn,
        turn * diagonal(1, -5, 3), diagonal(7, 1, 1) * turn * diagonal(1, 2, 9),
        diagonal(1e-6, 1e-6, 1e-6) * turn, turn * diagonal(1e6, 1e6, -1e6), diagonal(1e-6, 1, 1e6)}) {
    Mesh mesh = slanted();
    EXPECT_EQ(transformMesh(mesh, {linear, {}}), 0u);
    ASSERT_EQ(mesh.triangles.size(), 1u);
    // The plane's own normal is that of its corners, so the transformed one is too.
    for (const Vec3f& normal : mesh.normals) expectNear(toDouble(normal), windingNormal(mesh), 2e-6);
  }
}

TEST(Transform, TheIdentityChangesNoBit) {
  Mesh mesh = slanted();
  mesh.normals[0] = {0.6f, 0.8000001f, 0};  // off unit length by rounding
  const Mesh before = mesh;
  transformMesh(mesh, {});
  EXPECT_EQ(mesh.positions, before.positions);
  EXPECT_EQ(mesh.normals, before.normals);
  transformMesh(mesh, {{}, {1, 0, 0}});
  EXPECT_EQ(mesh.positions[0], (Vec3f{2, 0, 0}));
  EXPECT_EQ(mesh.normals, before.normals);
}

TEST(Transform, QuarterTurnsAreExact) {
  const Mat3 quarter = rotationAbout({0, 0, 2}, 90);
  EXPECT_EQ(quarter * Vec3d(3, 5, 7), Vec3d(-5, 3, 7));
  EXPECT_EQ(quarter * quarter, rotationAbout({0, 0, 1}, -180));
  EXPECT_EQ(rotationAbout({0, 1, 0}, 270) * Vec3d(1, 0, 0), Vec3d(0, 0, 1));
  EXPECT_EQ(rotationAbout({1, 0, 0}, 720), Mat3{});
  const double root = std::numbers::sqrt2 / 2;
  expectNear(rotationAbout({1, 0, 0}, 45) * Vec3d(0, 1, 0), {0, root, root}, 1e-15);
  // About (1,1,1) by a third of a turn: x goes to y goes to z.
  expectNear(rotationAbout({1, 1, 1}, 120) * Vec3d(1, 2, 3), {3, 1, 2}, 1e-15);
}

TEST(Transform, TellsSingularFromUneven) {
  EXPECT_FALSE(isSingular(diagonal(1e-200, 1, 1e200)));
  EXPECT_FALSE(isSingular(rotationAbout({1, 2, 3}, 40) * diagonal(1e-6, 1, 1e6)));
  EXPECT_FALSE(isSingular(diagonal(1e-6, 1, 1e6) * rotationAbout({1, 2, 3}, 40)));
  EXPECT_TRUE(isSingular(diagonal(1, 0, 1)));
  EXPECT_TRUE(isSingular({{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}));
  EXPECT_TRUE(isSingular({{{0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}, {0, 1, 0}}}));
}

TEST(Transform, TrianglesWithoutAreaGoWithTheirVertices) {
  // At a million, float resolves a sixteenth: the small triangle collapses, the large one stays.
  Mesh mesh = slanted();
  mesh.positions.insert(mesh.positions.begin(), {{0, 0, 0}, {0.001f, 0, 0}, {0, 0.001f, 0}});
  mesh.normals.resize(6, {0, 0, 1});
  mesh.textureCoordinates = {{9, 9}, {9, 9}, {9, 9}, {0, 0}, {1, 0}, {0, 1}};
  mesh.vertexMaterials = {1, 1, 1, 0, 0, 0};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_EQ(transformMesh(mesh, {{}, {1e6, 0, 0}}), 1u);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{1000001, 0, 0}, {1000000, 2, 0}, {1000000, 0, 3}}));
  EXPECT_EQ(mesh.textureCoordinates[2], (Vec2f{0, 1}));
  EXPECT_EQ(mesh.vertexMaterials, (std::vector<std::uint32_t>{0, 0, 0}));
  EXPECT_EQ(mesh.normals.size(), 3u);
}

TEST(SceneTransform, ScalesThenTurnsThenMoves) {
  test::writeScratch("m.obj", test::triangleObj());
  const Scene scene = loadText(oneObject(
      R"("transform": {"translate": [10, 0, 0], "rotate": {"axis": [0, 0, 1], "degrees": 90}, "scale": [2, 3, 1]})"));
  EXPECT_EQ(scene.mesh.positions, (std::vector<Vec3f>{{10, 0, 0}, {10, 2, 0}, {7, 0, 0}}));
}

TEST(SceneTransform, MatricesAreRowsAndHaveTwoSpellings) {
  test::writeScratch("m.obj", test::triangleObj());
  const std::string matrix = "[0, -3, 0, 10, 2, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]";
  for (const std::string& spelling : {matrix, "{\"matrix\": " + matrix + "}"})
    EXPECT_EQ(loadText(oneObject("\"transform\": " + spelling)).mesh.positions,
              (std::vector<Vec3f>{{10, 0, 0}, {10, 2, 0}, {7, 0, 0}}));
}

TEST(SceneTransform, MirrorsTurnTrianglesAround) {
  test::writeScratch("m.obj", test::triangleObj());
  const Scene scene = loadText(oneObject(R"("transform": {"scale": [-1, 1, 1]})"));
  EXPECT_EQ(windingNormal(scene.mesh), (Vec3d{0, 0, 1}));
  for (const Vec3f& normal : scene.mesh.normals) EXPECT_EQ(normal, (Vec3f{0, 0, 1}));
}

TEST(SceneTransform, RefusesByName) {
  test::writeScratch("m.obj", test::triangleObj());
  const auto refusal = [](const std::string& transform) {
    return errorOf(oneObject("\"transform\": " + transform));
  };
  const std::string place = "scene.json: objects[0].transform";
  for (const auto& [transform, problem] : std::initializer_list<std::pair<const char*, const char*>>{
           {"7", " is no object"},
           {R"({"shift": [1, 2, 3]})", ".shift is not known here"},
           {R"({"translate": [1, 2]})", ".translate does not have three numbers"},
           {R"({"translate": [1, 2, "3"]})", ".translate has an entry that is no finite number"},
           {R"({"scale": "2"})", ".scale is neither a number nor a list"},
           {R"({"scale": 0})", ".scale is zero"},
           {R"({"scale": [1, 0, 1]})", ".scale is zero"},
           {R"({"scale": [1, 1]})", ".scale does not have three numbers"},
           {R"({"rotate": "y:90"})", ".rotate is no object"},
           {R"({"rotate": {"axis": [0, 0, 0], "degrees": 1}})", ".rotate.axis is zero"},
           {R"({"rotate": {"axis": [0, 1, 0]}})", ".rotate.degrees is missing"},
           {R"({"rotate": {"axis": [0, 1, 0], "degrees": 1, "radians": 1}})", ".rotate.radians is not known"},
           {"[1, 2, 3]", " does not have 16 numbers"},
           {R"({"matrix": 1})", ".matrix does not have 16 numbers"},
           {"[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1]", " does not end with 0, 0, 0, 1"},
           {"[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, null, 0, 0, 0, 0, 1]", "[10] is no finite number"},
           {"[1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 0, 0, 0, 1]", " is singular"},
           {R"({"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], "scale": 2})",
            ".matrix is given beside other parts"},
           {R"({"scale": 1e39})", " moves vertices beyond the range of float"},
           {R"({"translate": [1e39, 0, 0]})", " moves vertices beyond the range of float"},
           {R"({"translate": [1e30, 1e30, 0]})", " leaves no triangle with area"},
           {R"({"scale": 1e-60})", " leaves no triangle with area"}})
    EXPECT_NE(refusal(transform).find(place + problem), std::string::npos) << transform << "\n"
                                                                           << refusal(transform);
}

}  // namespace
}  // namespace shprt
