// The rules of the loader, one small file at a time.
#include <algorithm>
#include <array>
#include <clocale>
#include <cmath>
#include <cstring>
#include <locale>
#include <numbers>
#include <set>

#include "shprt/base/file.h"
#include "shprt/mesh/position_ids.h"
#include "shprt/mesh/triangulate.h"
#include "shprt/mesh/write_ply.h"
#include "tests/mesh/mesh_files.h"

namespace shprt {
namespace {

using test::loadText;

TEST(LoadMesh, KeepsHardEdgesHard) {
  const Mesh cube = loadText("cube.obj", test::kCubeObj);
  EXPECT_EQ(cube.positions.size(), 24u);
  EXPECT_EQ(cube.triangles.size(), 12u);
  for (const Triangle& t : cube.triangles) {
    const Vec3d face = normalize(cross(toDouble(cube.positions[t[1]]) - toDouble(cube.positions[t[0]]),
                                       toDouble(cube.positions[t[2]]) - toDouble(cube.positions[t[0]])));
    for (const std::uint32_t corner : t) EXPECT_EQ(toFloat(face), cube.normals[corner]);
  }
  EXPECT_EQ(cube.report.generatedNormals, 36u);
}

TEST(LoadMesh, SmoothsBelowTheCreaseAngleWithAngleWeights) {
  const Mesh cube = loadText("cube.obj", test::kCubeObj, {.creaseAngleDegrees = 91});
  ASSERT_EQ(cube.positions.size(), 8u);
  // Each corner of a cube has three right angles, however the squares are cut: the mean is the diagonal.
  for (std::size_t v = 0; v < 8; ++v) {
    const Vec3d diagonal = normalize(toDouble(cube.positions[v]) - Vec3d{0.5, 0.5, 0.5});
    EXPECT_NEAR(length(diagonal - toDouble(cube.normals[v])), 0, 1e-6);
  }
}

TEST(LoadMesh, UsesTheNormalsOfTheFileUnlessACreaseAngleIsAsked) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nvn 0 3 4\nf 1//1 2//1 3//2\n";
  const Mesh own = loadText("normals.obj", text);
  EXPECT_EQ(own.normals[0], (Vec3f{0, 0, 1}));
  EXPECT_EQ(own.normals[2], toFloat({0, 0.6, 0.8}));
  EXPECT_TRUE(own.report.normalsFromFile);
  const Mesh computed = loadText("normals.obj", text, {.creaseAngleDegrees = 30});
  EXPECT_EQ(computed.normals[2], (Vec3f{0, 0, 1}));
  EXPECT_FALSE(computed.report.normalsFromFile);
}

TEST(LoadMesh, ComputesNormalsThatTheFileLacksOrGivesWrong) {
  const Mesh mesh = loadText("partial.obj",
                             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn nan 0 1\nvn 0 0 0\nvn 1 0 0\n"
                             "f 1//1 2//3 3//3\nf 2//3 4//3 3//3\nf 1//2 4//2 2//2\n");
  // One corner names a normal that is not a number, three name one without direction; the rest keep theirs.
  EXPECT_EQ(mesh.report.generatedNormals, 4u);
  EXPECT_TRUE(mesh.report.normalsFromFile);
  EXPECT_TRUE(test::hasNote(mesh, "4 corners without the normals they name"));
}

TEST(LoadMesh, TellsSeamsAndMaterialsApart) {
  const Mesh mesh = loadText("seams.obj",
                             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 0.5 0.5\n"
                             "usemtl a\nf 1/1 2/2 3/3\nf 2/2 4/4 3/1\nusemtl b\nf 1/1 3/3 2/2\n");
  // Two vertices of the second face are new: 4 and the seam at 3; the third face has another normal and
  // material.
  EXPECT_EQ(mesh.positions.size(), 8u);
  EXPECT_EQ(mesh.textureCoordinates[1], (Vec2f{1, 0}));
  ASSERT_EQ(mesh.materials.size(), 2u);
  EXPECT_EQ(mesh.materials[0].name, "a");
  EXPECT_EQ(mesh.materials[mesh.vertexMaterials[7]].name, "b");
}

TEST(LoadMesh, ReadsMaterialsAndTheirQuirks) {
  test::writeScratch(
      "some colours.mtl",
      "newmtl red\nKd 0.5 0.25 2\nnewmtl wood\nKd 1 1 1\nmap_Kd -s 2 2 1 -clamp on my wood.png\r\n");
  const LoadedMesh loaded =
      loadMesh(test::writeScratch("mtl.obj",
                                  "mtllib some colours.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wood\nf 1 2 "
                                  "3\nusemtl red\nf 3 2 1\nusemtl none\nf 1 2 3\n"));
  const Mesh& mesh = loaded.mesh;
  ASSERT_EQ(mesh.materials.size(), 3u);
  EXPECT_EQ(mesh.materials[0].diffuseTexture, "my wood.png");
  EXPECT_EQ(mesh.materials[1].diffuse, (Vec3f{0.5f, 0.25f, 1}));
  EXPECT_FALSE(mesh.materials[2].hasDiffuse);
  EXPECT_EQ(loaded.sources.size(), 2u);
  EXPECT_TRUE(test::hasNote(mesh, "clamped"));
  EXPECT_TRUE(test::hasNote(mesh, "options of map_Kd of 'wood' ignored"));
  EXPECT_TRUE(test::hasNote(mesh, "'none' is defined nowhere"));
}

TEST(LoadMesh, KeepsEveryKindOfNonManifoldFace) {
  // Three sheets on one edge, one of them twice, and one turned over.
  const Mesh mesh =
      loadText("fan.obj",
               "v 0 0 0\nv 0 0 1\nv 1 0 0\nv -1 0 0\nv 0 1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\nf 1 2 5\nf 2 1 5\n");
  EXPECT_EQ(mesh.triangles.size(), 5u);
  EXPECT_EQ(mesh.report.zeroAreaTriangles, 0u);
  // The two sides of the doubled sheet have opposite normals.
  std::set<float> sides;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v] == Vec3f{0, 1, 0}) sides.insert(mesh.normals[v].x);
  }
  EXPECT_EQ(sides, (std::set<float>{-1, 1}));
}

TEST(LoadMesh, EdgesOfThreeFacesAreHard) {
  // Two gentle slopes that alone would be smooth, and a fin between them.
  const std::string slopes = "v 0 0 0\nv 0 0 1\nv 1 0.1 0\nv -1 0.1 0\nv 0 1 0\nf 1 2 3\nf 2 1 4\n";
  EXPECT_EQ(loadText("slopes.obj", slopes).positions.size(), 4u);
  EXPECT_EQ(loadText("fin.obj", slopes + "f 1 2 5\n").positions.size(), 9u);
  // The same whichever face comes last.
  EXPECT_EQ(
      loadText("fin.obj", "v 0 0 0\nv 0 0 1\nv 1 0.1 0\nv -1 0.1 0\nv 0 1 0\nf 1 2 3\nf 1 2 5\nf 2 1 4\n")
          .positions.size(),
      9u);
}

TEST(LoadMesh, QuadsAreCutAlongTheShorterDiagonal) {
  const Mesh mesh = loadText("kite.obj", "v 0 0 0\nv 3 -1 0\nv 8 0 0\nv 3 1 0\nf 1 2 3 4\n");
  ASSERT_EQ(mesh.triangles.size(), 2u);
  for (const Triangle& triangle : mesh.triangles) {
    int onShort = 0;
    for (const std::uint32_t corner : triangle) onShort += mesh.positions[corner].x == 3;
    EXPECT_EQ(onShort, 2);
  }
}

TEST(LoadMesh, UnrollsTriangleStrips) {
  const Mesh mesh = loadText(
      "strip.ply",
      "ply\nformat ascii 1.0\nelement vertex 7\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n2 2 0\n10 0 1 2 3 4 -1 4 3 5 6\n");
  EXPECT_EQ(mesh.report.sourceFaces, 5u);
  EXPECT_EQ(mesh.triangles.size(), 5u);
  // All turn the same way, so all normals of the first strip agree.
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].y >= 2) continue;
    EXPECT_EQ(mesh.normals[v], (Vec3f{0, 0, 1})) << v;
  }
}

TEST(LoadMesh, BadPositionsDoNotShiftIndices) {
  const Mesh mesh = loadText("shift.obj",
                             "v 0 0 0\nv nan 0 0\nv 1e400 0 0\nv 0,5 1 1\nv 1 2\nv 0x1p3 0 0\nv +1 0 0\nv 0 "
                             "1 0\nf 1 7 8\nf 1 2 8\n");
  EXPECT_EQ(mesh.report.nonFiniteVertices, 5u);
  EXPECT_EQ(mesh.report.nonFiniteFaces, 1u);
  ASSERT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.positions[1], (Vec3f{1, 0, 0}));
  EXPECT_EQ(mesh.positions[2], (Vec3f{0, 1, 0}));
}

TEST(LoadMesh, ReadsIndicesOfEveryForm) {
  const Mesh mesh = loadText("forms.obj",
                             "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nf 1/ 2/ 3/\nf 1// 2// 3//\nf 4 5 "
                             "\\\n6\nf 1 2 99\nf 0 1 2\nf 1 x 2\nf 1.5 2 3\nf 1 2\n"
                             "v 0 0 1\nv 1 0 1\nv 0 1 1\n");
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.report.badIndexFaces, 4u);
  EXPECT_EQ(mesh.report.shortFaces, 1u);
}

TEST(LoadMesh, ReadsEveryLineEndAndByteOrderMark) {
  std::string cr = test::kCubeObj, crlf;
  for (char& c : cr) c = c == '\n' ? '\r' : c;
  for (const char c : test::kCubeObj) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  std::string utf16 = "\xff\xfe";
  for (const char c : test::kCubeObj) (utf16 += c) += '\0';
  for (const std::string& text : {cr, crlf, "\xef\xbb\xbf" + test::kCubeObj, utf16, utf16.substr(2)}) {
    EXPECT_EQ(loadText("ends.obj", text).positions.size(), 24u);
  }
}

TEST(LoadMesh, IgnoresTheLocale) {
  const char* old = std::setlocale(LC_ALL, nullptr);
  const std::string kept = old ? old : "C";
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) {
    // Without that locale on the machine the C++ side can still be turned to commas.
    struct Comma : std::numpunct<char> {
      char do_decimal_point() const override { return ','; }
    };
    std::locale::global(std::locale(std::locale::classic(), new Comma));
  }
  const Mesh mesh = loadText("locale.obj", "v 0 0 0\nv 1.5 0 0\nv 0 1.25 0\nf 1 2 3\n");
  std::locale::global(std::locale::classic());
  std::setlocale(LC_ALL, kept.c_str());
  EXPECT_EQ(mesh.positions[1].x, 1.5f);
  EXPECT_EQ(mesh.positions[2].y, 1.25f);
}

double area(const std::vector<Vec3d>& corners, const std::vector<std::array<std::uint32_t, 3>>& triangles,
            Vec3d normal) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const double twice = dot(cross(corners[b] - corners[a], corners[c] - corners[a]), normal);
    EXPECT_GE(twice, -1e-12);  // none is turned over
    sum += twice / 2;
  }
  return sum;
}

TEST(Triangulate, CutsConcavePolygonsInAnyPlane) {
  // A comb with teeth: 3 of height 2 on a base of height 1, width 5.
  const std::vector<Vec3d> flat = {{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {4, 3, 0}, {4, 1, 0}, {3, 1, 0},
                                   {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  for (const int axis : {0, 1, 2})
    for (const bool reversed : {false, true})
      for (const double scale : {1e-30, 1.0, 1e30}) {
        std::vector<Vec3d> corners;
        for (const Vec3d& p : flat)
          corners.push_back((axis == 0   ? p
                             : axis == 1 ? Vec3d{p.y, p.z, p.x}
                                         : Vec3d{p.z, p.x, p.y}) *
                            scale);
        if (reversed) std::reverse(corners.begin(), corners.end());
        std::vector<std::array<std::uint32_t, 3>> triangles;
        TriangulationBudget budget;
        EXPECT_TRUE(triangulate(corners, triangles, budget));
        ASSERT_EQ(triangles.size(), corners.size() - 2);
        const Vec3d axisNormal = axis == 0 ? Vec3d{0, 0, 1} : axis == 1 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
        for (Vec3d& p : corners) p = p / scale;
        EXPECT_NEAR(area(corners, triangles, reversed ? -axisNormal : axisNormal), 5 + 3 * 2, 1e-9);
      }
}

TEST(Triangulate, CutsAroundABridgedHole) {
  // A square with a square hole, joined by a bridge that is walked twice.
  const std::vector<Vec3d> corners = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                      {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  std::vector<std::array<std::uint32_t, 3>> triangles;
  TriangulationBudget budget;
  triangulate(corners, triangles, budget);
  ASSERT_EQ(triangles.size(), 8u);
  EXPECT_NEAR(area(corners, triangles, {0, 0, 1}), 12, 1e-12);
}

TEST(LoadMesh, PolygonsThatNameAVertexTwiceKeepTheirHole) {
  const Mesh mesh = loadText(
      "hole.obj",
      "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\nf 1 2 3 4 1 5 6 7 8 5\n");
  EXPECT_EQ(mesh.triangles.size(), 8u);
  EXPECT_EQ(mesh.positions.size(), 8u);
  EXPECT_EQ(mesh.report.sourceVertices, 8u);
  EXPECT_EQ(mesh.report.unreferencedVertices, 0u);
}

TEST(Triangulate, AlwaysEnds) {
  // A star that crosses itself, a line, a point, and a polygon of many corners.
  std::vector<Vec3d> star, line, point(7, Vec3d{1, 1, 1}), gear;
  for (int i = 0; i < 11; ++i)
    star.push_back(
        {std::cos(i * 5 * 2 * std::numbers::pi / 11), std::sin(i * 5 * 2 * std::numbers::pi / 11), 0});
  for (int i = 0; i < 9; ++i) line.push_back({double(i % 5), 2.0 * (i % 5), 0});
  for (int i = 0; i < 3000; ++i) {
    const double r = i % 2 ? 1 : 1.2, a = i * 2 * std::numbers::pi / 3000;
    gear.push_back({r * std::cos(a), r * std::sin(a), 0});
  }
  for (const auto& corners : {star, line, point, gear}) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    TriangulationBudget budget;
    triangulate(corners, triangles, budget);
    EXPECT_EQ(triangles.size(), corners.size() - 2);
  }
}

TEST(LoadMesh, WorksAtTheEndsOfTheRange) {
  for (const char* size : {"1e-37", "1e-20", "1e30", "3e38"}) {
    const std::string s = size;
    const Mesh mesh = loadText("size.obj", "v 0 0 0\nv " + s + " 0 0\nv 0 " + s + " 0\nf 1 2 3\n");
    EXPECT_EQ(mesh.triangles.size(), 1u) << s;
    EXPECT_EQ(mesh.normals[0], (Vec3f{0, 0, 1})) << s;
  }
  const Mesh flat = loadText("flat.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nv 0 1 0\nf 1 2 3\nf 1 2 4\n");
  EXPECT_EQ(flat.report.zeroAreaTriangles, 1u);
}

TEST(WritePly, ReadsBackTheSame) {
  const Mesh cube = loadText("cube.obj", test::kCubeObj);
  const std::vector<std::array<std::uint8_t, 3>> colours(cube.positions.size(), {1, 2, 3});
  const std::vector<Vec3f> radiance(cube.positions.size(), Vec3f{0.5f, 1, 2});
  writePly(test::scratch("cube_out.ply"), cube.positions, cube.normals, colours, radiance, cube.triangles);
  const Mesh back = loadMesh(test::scratch("cube_out.ply")).mesh;
  ASSERT_EQ(back.positions.size(), cube.positions.size());
  ASSERT_EQ(back.triangles.size(), cube.triangles.size());
  for (std::size_t t = 0; t < cube.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(back.positions[back.triangles[t][k]], cube.positions[cube.triangles[t][k]]);
      EXPECT_EQ(back.normals[back.triangles[t][k]], cube.normals[cube.triangles[t][k]]);
    }
}

TEST(WritePly, PutsStandardErrorsBehindRadiance) {
  const Mesh cube = loadText("cube.obj", test::kCubeObj);
  const std::vector<std::array<std::uint8_t, 3>> colours(cube.positions.size(), {1, 2, 3});
  const std::vector<Vec3f> radiance(cube.positions.size(), Vec3f{0.5f, 1, 2}),
      errors(cube.positions.size(), Vec3f{0.25f, 0.125f, 0});
  const auto written = [&](std::span<const Vec3f> standardErrors) {
    writePly(test::scratch("errors.ply"), cube.positions, cube.normals, colours, radiance, cube.triangles,
             standardErrors);
    return readFile(test::scratch("errors.ply"));
  };
  const std::string plain = written({}), measured = written(errors);
  EXPECT_EQ(plain.find("error"), std::string::npos);
  const std::string properties =
      "property float radiance_b\nproperty float radiance_error_r\nproperty float radiance_error_g\n"
      "property float radiance_error_b\nelement face";
  EXPECT_NE(measured.find(properties), std::string::npos);
  // Three floats of radiance and three of errors end a vertex; the first vertex has 51 bytes.
  float last[6];
  std::memcpy(last, measured.data() + measured.find("end_header\n") + 11 + 51 - sizeof last, sizeof last);
  EXPECT_EQ(std::vector<float>(last, last + 6), (std::vector<float>{0.5f, 1, 2, 0.25f, 0.125f, 0}));
  EXPECT_EQ(loadMesh(test::scratch("errors.ply")).mesh.triangles.size(), cube.triangles.size());
}

TEST(LoadMesh, RefusesWhatIsNoMesh) {
  EXPECT_NE(test::errorOf(SHPRT_TEST_OUTPUT_DIR).find("is a directory"), std::string::npos);
  EXPECT_NE(test::errorOf("/no/such.obj").find("no such file"), std::string::npos);
  EXPECT_NE(test::errorOf(test::writeScratch("a.xyz", "hello")).find("no mesh format"), std::string::npos);
  EXPECT_NE(test::errorOf(test::writeScratch("a.ply", "hello")).find("does not begin with 'ply'"),
            std::string::npos);
  EXPECT_NE(test::errorOf(test::writeScratch("a.off", "hello")).find("does not begin with OFF"),
            std::string::npos);
  EXPECT_NE(test::errorOf(
                test::writeScratch("b.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"))
                .find("no end_header"),
            std::string::npos);
  EXPECT_NE(
      test::errorOf(test::writeScratch("c.ply",
                                       "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float "
                                       "x\nproperty float y\nproperty float z\nend_header\n1 2 3\n"))
          .find("more than its"),
      std::string::npos);
}

// --- damage
// -----------------------------------------------------------------------------------------------------------

template <typename T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

struct Sample {
  std::string name, bytes;
};

// A tetrahedron in each format, binary where there is one.
std::vector<Sample> tetrahedra() {
  const float positions[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::int32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
      "float z\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  std::string bigPly =
      "ply\nformat binary_big_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty "
      "double z\n"
      "element face 4\nproperty list uint ushort vertex_index\nend_header\n";
  std::string off = "OFF BINARY\n", stl(80, ' '), obj, asciiOff = "OFF\n4 4 0\n", asciiStl = "solid t\n",
              asciiPly =
                  "ply\nformat ascii 1.0\nelement face 4\nproperty list uchar int vertex_indices\nelement "
                  "vertex 4\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  const auto big = [](std::string& bytes, auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(std::string(std::rbegin(raw), std::rend(raw)));
  };
  append(off, std::int32_t{4}), append(off, std::int32_t{4}), append(off, std::int32_t{0});
  append(stl, std::uint32_t{4});
  for (const auto& p : positions) {
    const std::string text =
        std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
    obj += "v " + text;
    asciiOff += text;
    for (const float c : p) append(ply, c), append(off, c), big(bigPly, static_cast<double>(c));
  }
  for (const auto& f : faces) {
    append(ply, std::uint8_t{3}), append(off, std::int32_t{3}), big(bigPly, std::uint32_t{3});
    for (int i = 0; i < 3; ++i) append(stl, 0.0f);
    asciiStl += "facet normal 0 0 0\nouter loop\n";
    for (const std::int32_t i : f) {
      append(ply, i), append(off, i), big(bigPly, static_cast<std::uint16_t>(i));
      for (const float c : positions[i]) append(stl, c);
      asciiStl += "vertex " + std::to_string(positions[i][0]) + " " + std::to_string(positions[i][1]) + " " +
                  std::to_string(positions[i][2]) + "\n";
    }
    append(stl, std::uint16_t{0});
    asciiStl += "endloop\nendfacet\n";
    const std::string zero = std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]);
    obj += "f " + std::to_string(f[0] + 1) + " " + std::to_string(f[1] + 1) + " " + std::to_string(f[2] + 1) +
           "\n";
    asciiOff += "3 " + zero + "\n";
    asciiPly += "3 " + zero + "\n";
  }
  for (const auto& p : positions)
    asciiPly += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
  asciiStl += "endsolid t\n";
  return {{"t.ply", ply},       {"tb.ply", bigPly}, {"ta.ply", asciiPly}, {"t.off", off},
          {"ta.off", asciiOff}, {"t.stl", stl},     {"ta.stl", asciiStl}, {"t.obj", obj}};
}

TEST(Damage, WholeSamplesLoadInEveryFormat) {
  for (const Sample& sample : tetrahedra()) {
    const Mesh mesh = loadText(sample.name, sample.bytes);
    EXPECT_EQ(mesh.triangles.size(), 4u) << sample.name;
    EXPECT_EQ(mesh.positions.size(), 12u) << sample.name;  // hard edges
    EXPECT_EQ(mesh.report.sourceVertices, 4u) << sample.name;
  }
}

TEST(Damage, EveryTruncationLoadsWhatIsThereOrIsRefused) {
  for (const Sample& sample : tetrahedra())
    for (std::size_t length = 0; length < sample.bytes.size(); ++length) {
      try {
        const Mesh mesh = loadText("cut_" + sample.name, sample.bytes.substr(0, length));
        // Text without counts may end early without a trace; formats with counts may lose only what comes
        // after them.
        EXPECT_TRUE(sample.name == "t.obj" || sample.name == "ta.stl" || mesh.triangles.size() == 4)
            << sample.name << " " << length;
      } catch (const Error&) {
      }
    }
}

TEST(Damage, FlippedBytesNeverCrash) {
  for (const Sample& sample : tetrahedra())
    for (std::size_t at = 0; at < sample.bytes.size(); ++at)
      for (const unsigned char flip : {0x01, 0x80, 0xff}) {
        std::string bytes = sample.bytes;
        bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ flip);
        try {
          const Mesh mesh = loadText("flip_" + sample.name, bytes);
          for (const Vec3f& p : mesh.positions) ASSERT_TRUE(isFinite(p));
        } catch (const Error& error) {
          ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
      }
}

}  // namespace
}  // namespace shprt
