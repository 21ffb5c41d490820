// Colours of vertices, from files made by hand and from shared ones whose values can be read off them.
#include <algorithm>
#include <array>
#include <map>

#include "tests/mesh/mesh_files.h"

namespace shprt {
namespace {

using test::hasNote;
using test::loadText;

// Three vertices with what follows their positions, and a face.
std::string triangleObj(const char* a, const char* b, const char* c) {
  return std::string("v 0 0 0 ") + a + "\nv 1 0 0 " + b + "\nv 0 1 0 " + c + "\nf 1 2 3\n";
}

std::string triangleOff(const char* a, const char* b, const char* c) {
  return std::string("OFF\n3 1 0\n0 0 0 ") + a + "\n1 0 0 " + b + "\n0 1 0 " + c + "\n3 0 1 2\n";
}

std::string trianglePly(const std::string& type, const std::string& prefix, const char* colours) {
  const std::string property = "property " + type + " " + prefix;
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
         property + "red\n" + property + "green\n" + property + "blue\nelement face 1\n" +
         "property list uchar int vertex_indices\nend_header\n" + colours + "3 0 1 2\n";
}

TEST(VertexColours, OfObjAreFractions) {
  const Mesh mesh = loadText("fractions.obj", triangleObj("0.25 0.5 1", "0 0 0", "1 1 1 # white"));
  EXPECT_EQ(mesh.colours, (std::vector<Vec3f>{{0.25f, 0.5f, 1}, {0, 0, 0}, {1, 1, 1}}));
  EXPECT_FALSE(mesh.coloursAreIntegers);
  EXPECT_TRUE(mesh.report.notes.empty());
}

TEST(VertexColours, AreReadWithAlphaAndNotFromAWeight) {
  const Mesh mesh = loadText("alpha.obj", triangleObj("0.25 0.5 1 0.5", "1 0 0 1", "0 1 0 1"));
  EXPECT_EQ(mesh.colours, (std::vector<Vec3f>{{0.25f, 0.5f, 1}, {1, 0, 0}, {0, 1, 0}}));
  const Mesh weighted = loadText("weight.obj", triangleObj("1", "1", "0.5"));
  EXPECT_TRUE(weighted.colours.empty());
  EXPECT_TRUE(weighted.report.notes.empty());
  EXPECT_TRUE(loadText("none.obj", triangleObj("", "", "")).colours.empty());
}

TEST(VertexColours, AboveOneCountTo255) {
  for (const Mesh& mesh : {loadText("bytes.obj", triangleObj("255 0 51", "1 1 1", "0 102 255")),
                           loadText("bytes.off", triangleOff("255 0 51", "1 1 1", "0 102 255 255"))}) {
    EXPECT_EQ(mesh.colours, (std::vector<Vec3f>{{1, 0, 0.2f}, Vec3f{1, 1, 1} / 255.0f, {0, 0.4f, 1}}));
    EXPECT_TRUE(mesh.coloursAreIntegers);
    EXPECT_TRUE(hasNote(mesh, "taken as 0 to 255"));
  }
}

TEST(VertexColours, OutsideAreClamped) {
  const Mesh mesh = loadText("outside.obj", triangleObj("1.5 -1 0.5", "0 0 0", "0 0 0"));
  EXPECT_EQ(mesh.colours[0], (Vec3f{1, 0, 0.5f}));
  EXPECT_FALSE(mesh.coloursAreIntegers);
  EXPECT_TRUE(hasNote(mesh, "colours of vertices clamped"));
}

TEST(VertexColours, MayBeMissingOrUnreadable) {
  const Mesh mesh = loadText("some.obj", triangleObj("1 0 0", "", "1 nan 0"));
  EXPECT_EQ(mesh.colours, (std::vector<Vec3f>{{1, 0, 0}, kNoColour, kNoColour}));
  EXPECT_EQ(loadText("gap.obj", triangleObj("", "", "0 1 0")).colours[2], (Vec3f{0, 1, 0}));
  EXPECT_TRUE(hasNote(mesh, "colours of 1 vertex cannot be read"));
  EXPECT_TRUE(hasNote(mesh, "1 vertex without colour"));
  const Mesh palette = loadText("palette.off", triangleOff("7", "7", "7"));
  EXPECT_TRUE(palette.colours.empty());
  EXPECT_TRUE(hasNote(palette, "values after coordinates that are no colour ignored"));
}

TEST(VertexColours, OfPlyGoByTheirType) {
  const char* low = "0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n";
  for (const std::string prefix : {"", "diffuse_"}) {
    const Mesh bytes = loadText("bytes.ply", trianglePly("uchar", prefix, low));
    EXPECT_EQ(bytes.colours[0], (Vec3f{1 / 255.0f, 0, 0}));
    EXPECT_TRUE(bytes.coloursAreIntegers);
    EXPECT_TRUE(bytes.report.notes.empty());
  }
  const Mesh words = loadText("words.ply", trianglePly("ushort", "", low));
  EXPECT_EQ(words.colours[1], (Vec3f{0, 1 / 65535.0f, 0}));
  const Mesh fractions = loadText("fractions.ply", trianglePly("float", "", low));
  EXPECT_EQ(fractions.colours[2], (Vec3f{0, 0, 1}));
  EXPECT_FALSE(fractions.coloursAreIntegers);
}

TEST(VertexColours, MakeVerticesDistinct) {
  // Two triangles in a plane that meet at two places; the four vertices there differ only in colour.
  const std::string places = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\n";
  const std::string others = "v 1 0 0 0 0 1\nv 1 1 0 0 0 1\nv 0 1 0 0 0 1\n";
  EXPECT_EQ(loadText("two.obj", places + others + "f 1 2 3\nf 4 5 6\n").positions.size(), 6u);
  const Mesh same =
      loadText("same.obj", places + "v 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\nf 4 5 6\n");
  EXPECT_EQ(same.positions.size(), 4u);
}

TEST(VertexColours, FollowVerticesThatAFaceNamesTwice) {
  // A square with a square hole, joined by a bridge.
  const std::string square = "v 0 0 0 1 0 0\nv 4 0 0 1 0 0\nv 4 4 0 1 0 0\nv 0 4 0 1 0 0\n";
  const std::string hole = "v 1 1 0 0 1 0\nv 1 3 0 0 1 0\nv 3 3 0 0 1 0\nv 3 1 0 0 1 0\n";
  const Mesh mesh = loadText("hole.obj", square + hole + "f 1 2 3 4 1 5 6 7 8 5\n");
  ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
  for (std::size_t v = 0; v < mesh.colours.size(); ++v) {
    const bool inner = mesh.positions[v].x > 0 && mesh.positions[v].x < 4;
    EXPECT_EQ(mesh.colours[v], (inner ? Vec3f{0, 1, 0} : Vec3f{1, 0, 0}));
  }
}

TEST(VertexColours, SurviveDamage) {
  const std::string low = "0 0 0 9 0 0\n1 0 0 0 9 0\n0 1 0 0 0 9\n";
  const std::initializer_list<std::pair<const char*, std::string>> samples = {
      {"t.obj", triangleObj("255 0 9", "1 1 1", "0 7 255")},
      {"t.off", triangleOff("255 0 9", "1 1 1 1", "0 7 255")},
      {"t.ply", trianglePly("uchar", "", low.c_str())},
      {"f.ply", trianglePly("float", "", low.c_str())}};
  for (const auto& [name, whole] : samples)
    for (std::size_t at = 0; at < whole.size(); ++at)
      for (const int flip : {0, 1, 0x10, 0x80}) {
        std::string damaged = flip ? whole : whole.substr(0, at);
        if (flip) damaged[at] = static_cast<char>(damaged[at] ^ flip);
        try {
          const Mesh mesh = loadText(name, damaged);
          ASSERT_TRUE(mesh.colours.empty() || mesh.colours.size() == mesh.positions.size());
          for (const Vec3f& c : mesh.colours)
            ASSERT_TRUE(c == kNoColour || (std::min({c.x, c.y, c.z}) >= 0 && std::max({c.x, c.y, c.z}) <= 1));
        } catch (const Error&) {
        }
      }
}

TEST(Materials, TheFirstDefinitionStands) {
  std::filesystem::create_directory(test::scratch("other"));
  test::writeScratch("a.mtl", "newmtl paint\nmap_Kd a.png\n");
  test::writeScratch("other/b.mtl", "newmtl paint\nmap_Kd b.png\n");
  const Mesh mesh = loadText(
      "m.obj", "mtllib a.mtl\nmtllib other/b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl paint\nf 1 2 3\n");
  EXPECT_EQ(mesh.materials[0].diffuseTexture, "a.png");
  EXPECT_NE(std::filesystem::path(mesh.materials[0].folder).filename(), "other");
}

TEST(Materials, EmissionIsReadAndSpecularColourNoted) {
  test::writeScratch("light.mtl",
                     "newmtl lamp\nKd 0 0 0\nKe 17 12 4.5\nKs 0.1 0 0\nnewmtl odd\nKe -1 2 0\nKs 0 0 0\n"
                     "newmtl broken\nKe 1 2\n");
  const Mesh mesh = loadText("light.obj",
                             "mtllib light.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl lamp\nf 1 2 3\n"
                             "usemtl odd\nf 1 2 3\nusemtl broken\nf 1 2 3\n");
  ASSERT_EQ(mesh.materials.size(), 3u);
  EXPECT_EQ(mesh.materials[0].emission, (Vec3f{17, 12, 4.5f}));
  EXPECT_EQ(mesh.materials[1].emission, (Vec3f{0, 2, 0}));
  EXPECT_EQ(mesh.materials[2].emission, (Vec3f{0, 0, 0}));
  EXPECT_EQ(std::filesystem::path(mesh.materials[0].folder),
            std::filesystem::path(test::scratch("")).parent_path());
  EXPECT_TRUE(hasNote(mesh, "light.mtl: Ks of 1 material ignored"));
  EXPECT_TRUE(hasNote(mesh, "Ke of 'odd' clamped"));
  EXPECT_TRUE(hasNote(mesh, "Ke of 'broken' cannot be read"));
}

TEST(SharedMeshes, CubeHasItsCornersAsColours) {
  const std::filesystem::path path = SHPRT_SHARED_DIR "/data/meshes/cube-vertexcol.obj";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "SKIPPED: no " << path;
  const Mesh mesh = loadMesh(path).mesh;
  ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
  // Red is 1 where z is 0, green is 1 where x is 2, blue is 1 where x and y agree.
  for (std::size_t v = 0; v < mesh.colours.size(); ++v) {
    const Vec3f p = mesh.positions[v];
    EXPECT_EQ(mesh.colours[v], (Vec3f{1 - p.z / 2, p.x / 2, p.x == p.y ? 1.0f : 0.0f}));
  }
}

// Every render vertex's colour is one that the file's bytes give at its position. offset: of the first colour
// in a record; colourAt reads one channel there.
template <typename Position, typename Colour>
void expectColoursOfBinaryPly(const Mesh& mesh, const std::string& bytes, std::size_t vertices,
                              std::size_t stride, std::size_t offset, float full) {
  const std::size_t begin = bytes.find("end_header\n") + 11;
  const auto read = [&]<typename T>(std::size_t at, T value) {
    std::copy_n(bytes.data() + at, sizeof value, reinterpret_cast<char*>(&value));
    return static_cast<float>(value);
  };
  std::multimap<std::array<float, 3>, Vec3f> colours;
  for (std::size_t v = 0; v < vertices; ++v) {
    const std::size_t record = begin + v * stride;
    const auto place = [&](std::size_t i) { return read(record + i * sizeof(Position), Position{}); };
    const auto channel = [&](std::size_t i) {
      return read(record + offset + i * sizeof(Colour), Colour{}) / full;
    };
    colours.insert({{place(0), place(1), place(2)}, {channel(0), channel(1), channel(2)}});
  }
  ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3f p = mesh.positions[v];
    const auto [first, last] = colours.equal_range({p.x, p.y, p.z});
    ASSERT_TRUE(std::any_of(first, last, [&](const auto& entry) { return entry.second == mesh.colours[v]; }));
  }
}

TEST(SharedMeshes, PlyColoursAreThoseOfTheBytes) {
  const std::filesystem::path folder = SHPRT_SHARED_DIR "/data/meshes";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "SKIPPED: no " << folder;
  // Headers: double x y z, uchar red green blue alpha, double quality.
  const std::filesystem::path airplane = folder / "colored_airplane.ply";
  const Mesh plane = loadMesh(airplane).mesh;
  EXPECT_TRUE(plane.coloursAreIntegers);
  expectColoursOfBinaryPly<double, std::uint8_t>(plane, readFile(airplane), 7017, 36, 24, 255);
  // Float x y z, nx ny nz, color_0 to 2.
  const std::filesystem::path bunny = folder / "bunny_attribute_color.ply";
  const Mesh rabbit = loadMesh(bunny).mesh;
  EXPECT_FALSE(rabbit.coloursAreIntegers);
  expectColoursOfBinaryPly<float, float>(rabbit, readFile(bunny), 6056, 36, 24, 1);
}

}  // namespace
}  // namespace shprt
