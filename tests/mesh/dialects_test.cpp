// What exporters make of the formats: every dialect is read as it is meant, and what is passed over is said.
#include <cctype>
#include <cmath>

#include "shprt/mesh/text.h"
#include "tests/mesh/mesh_files.h"

namespace shprt {
namespace {

using test::hasNote;
using test::loadText;

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kPlyVertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kPlyPlaces = "0 0 0\n1 0 0\n0 1 0\n";
const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

TEST(ParseFloat, GivesTheNearestFloat) {
  // 1 + 2^-24 + 2^-54 lies above the middle between 1 and its neighbour; by way of double it would lie on it.
  EXPECT_EQ(parseFloat("1.0000000596046448031462006156289135105907917022705078125"),
            std::nextafter(1.0f, 2.0f));
  EXPECT_EQ(parseFloat("1.000000059604644775390625"), 1.0f);  // the middle itself: to even
}

TEST(ParseFloat, TellsTooSmallFromTooLarge) {
  const std::string zeros(400, '0');
  EXPECT_EQ(parseFloat("1e-400"), 0.0f);
  EXPECT_EQ(parseFloat("-0." + zeros + "1"), 0.0f);
  EXPECT_EQ(parseFloat("0." + zeros + "1e402"), 10.0f);
  EXPECT_FALSE(parseFloat("1" + zeros));
  EXPECT_FALSE(parseFloat("1" + zeros + "e-2"));
  EXPECT_FALSE(parseFloat("1e99999999999999999999"));
  EXPECT_EQ(parseFloat("1e-99999999999999999999"), 0.0f);
  for (const char* token : {"", "+", "+-1", "0x1", "1,5", "nan", "inf", "1e", "1 "})
    EXPECT_FALSE(parseFloat(token));
}

TEST(Obj, CommentsDoNotContinueAndAreNoColours) {
  const Mesh mesh =
      loadText("comment.obj", "# C:\\models\\\nv 0 0 0 # a b c\nv 1 0 0\nv 0 1 0\nf 1 2 3 # f 9 9 9\n");
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_TRUE(mesh.report.notes.empty());
  EXPECT_TRUE(mesh.colours.empty());
}

TEST(Obj, CornersKeepWhatTheirNeighboursLack) {
  const Mesh mesh = loadText("mixed.obj", kCorners +
                                              "vt 0.25 0.5\nvt 0.75 1\nvn 0 0 2\n"
                                              "f 1/1/1 2/2 3\nf 2/9/1 1/1/7 3//1\n");
  ASSERT_EQ(mesh.triangles.size(), 2u);
  const Triangle first = mesh.triangles[0], second = mesh.triangles[1];
  EXPECT_EQ(mesh.textureCoordinates[first[0]], (Vec2f{0.25f, 0.5f}));
  EXPECT_EQ(mesh.textureCoordinates[first[1]], (Vec2f{0.75f, 1}));
  EXPECT_EQ(mesh.textureCoordinates[first[2]], (Vec2f{0, 0}));
  EXPECT_EQ(mesh.textureCoordinates[second[1]], (Vec2f{0.25f, 0.5f}));
  EXPECT_EQ(mesh.normals[second[0]], (Vec3f{0, 0, 1}));
  EXPECT_EQ(mesh.normals[second[1]], (Vec3f{0, 0, -1}));  // computed: this face looks down
  EXPECT_EQ(mesh.report.generatedNormals, 3u);
  EXPECT_TRUE(hasNote(mesh, "1 corner without the texture coordinates"));
  EXPECT_TRUE(hasNote(mesh, "1 corner without the normals"));
}

TEST(Obj, IgnoredLinesAreCountedByKind) {
  const Mesh mesh = loadText("kinds.obj", kCorners + "l 1 2\nl 2 3\np 1\ng a\ns 1\nf 1 2 3\n");
  EXPECT_EQ(mesh.report.notes, (std::vector<std::string>{"2 lines 'l' ignored", "1 line 'p' ignored"}));
}

TEST(Obj, MissingMaterialFileIsANote) {
  const Mesh mesh = loadText("lost.obj", "mtllib no such.mtl\n" + kCorners + "f 1 2 3\nusemtl a\nf 1 2 3\n");
  ASSERT_EQ(mesh.materials.size(), 2u);
  EXPECT_EQ(mesh.materials[0].name, "");
  EXPECT_EQ(mesh.materials[1].name, "a");
  EXPECT_TRUE(hasNote(mesh, "'no such.mtl' not found"));
}

TEST(Obj, MaterialFilesMayBeMarkedAndTheirOptionsTakeWords) {
  test::writeScratch(
      "marked.mtl",
      "\xef\xbb\xbfnewmtl a\nKd 2 3 0.5\nmap_Kd -imfchan r -type sphere -s 1 1 -clamp on my wood.png\n"
      "newmtl b\nKd spectral file.rfl 1\n");
  const Mesh mesh =
      loadText("marked.obj", "mtllib marked.mtl\n" + kCorners + "usemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n");
  ASSERT_EQ(mesh.materials.size(), 2u);
  EXPECT_EQ(mesh.materials[0].diffuse, (Vec3f{1, 1, 0.5f}));
  EXPECT_EQ(mesh.materials[0].diffuseTexture, "my wood.png");
  EXPECT_FALSE(mesh.materials[1].hasDiffuse);
  EXPECT_TRUE(hasNote(mesh, "Kd of 'b' cannot be read"));
}

TEST(Obj, Utf16KeepsNamesApart) {
  // Two Chinese names of one character each, in UTF-16 little-endian.
  std::string utf16 = "\xff\xfe";
  const auto append = [&](const std::string& ascii) {
    for (const char c : ascii) (utf16 += c) += '\0';
  };
  append(kCorners + "usemtl ");
  utf16 += "\x28\x67";  // U+6728
  append("\nf 1 2 3\nusemtl ");
  utf16 += "\xf3\x77";  // U+77F3
  append("\nf 1 3 2\n");
  const Mesh mesh = loadText("names.obj", utf16);
  ASSERT_EQ(mesh.materials.size(), 2u);
  EXPECT_EQ(mesh.materials[0].name, "\xe6\x9c\xa8");
  EXPECT_EQ(mesh.materials[1].name, "\xe7\x9f\xb3");
}

TEST(Ply, StripsAndTexturedFacesMix) {
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  const std::string faces =
      "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n";
  const std::string strip = "4 0 1 2 0\n", face = "3 0 1 2 6 0 0 0.5 0 0 0.5\n";
  for (const bool stripsFirst : {false, true}) {
    const Mesh mesh =
        loadText("mix.ply", "ply\nformat ascii 1.0\n" + kPlyVertices +
                                (stripsFirst ? strips + faces : faces + strips) + "end_header\n" +
                                kPlyPlaces + (stripsFirst ? strip + face : face + strip));
    EXPECT_EQ(mesh.report.sourceTriangles, 3u);
    EXPECT_EQ(mesh.report.zeroAreaTriangles, 0u);
    const Triangle textured = mesh.triangles[stripsFirst ? 2 : 0],
                   other = mesh.triangles[stripsFirst ? 0 : 1];
    EXPECT_EQ(mesh.textureCoordinates[textured[1]], (Vec2f{0.5f, 0}));
    EXPECT_EQ(mesh.textureCoordinates[other[1]], (Vec2f{0, 0}));
  }
}

TEST(Ply, StripsTurnEverySecondTriangleAndRestart) {
  const Mesh mesh = loadText("strip.ply",
                             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                             "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                             "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 1 2\n");
  ASSERT_EQ(mesh.triangles.size(), 3u);
  for (const Vec3f& normal : mesh.normals) EXPECT_EQ(normal, (Vec3f{0, 0, 1}));
}

TEST(Ply, SaysWhatItPassesOver) {
  const Mesh mesh = loadText(
      "extra.ply", "ply \r\nformat ascii 1.0\r\n" + kPlyVertices +
                       "property uchar red\nproperty float quality\nelement face 1\nproperty list uchar int "
                       "vertex_index\nproperty int flags\nelement edge 1\nproperty int a\nend_header\n"
                       "0 0 0 9 1\n1 0 0 9 1\n0 1 0 9 1\n3 0 1 2 7\n5\n3 0 2 1 7\n");
  EXPECT_EQ(mesh.report.sourceFaces, 1u);
  EXPECT_TRUE(mesh.colours.empty());  // red alone is none
  EXPECT_TRUE(hasNote(mesh, "properties of element 'vertex' ignored: red, quality"));
  EXPECT_TRUE(hasNote(mesh, "properties of element 'face' ignored: flags"));
  EXPECT_TRUE(hasNote(mesh, "element 'edge' (1 record) ignored"));
  EXPECT_TRUE(hasNote(mesh, "10 bytes after the last record ignored"));
}

TEST(Ply, RefusesTheSameElementTwice) {
  const std::string path = test::writeScratch(
      "twice.ply", "ply\nformat ascii 1.0\n" + kPlyVertices + kPlyVertices +
                       "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + kPlyPlaces +
                       kPlyPlaces + "3 0 1 2\n");
  EXPECT_NE(test::errorOf(path).find("the element 'vertex' twice"), std::string::npos);
}

TEST(Off, ReadsEveryCombinationOfItsPrefix) {
  // Position, normal (0,0,1), colour, texture coordinate: in this order, each only where the prefix names it.
  for (const bool texture : {false, true})
    for (const bool colour : {false, true})
      for (const bool normal : {false, true}) {
        std::string text = std::string("  # made by hand\n") + (texture ? "ST" : "") + (colour ? "C" : "") +
                           (normal ? "N" : "") + "OFF 3 1 0 # counts\n\n";
        for (const char* place : {"0 0 0", "1 0 0", "0 1 0"}) {
          text += std::string(place) + (normal ? " 0 0 -3" : "") + (colour ? " 255 0 0 255" : "") +
                  (texture ? " 0.5 0.25" : "") + "\n";
        }
        const Mesh mesh = loadText("prefix.off", text + "3 0 1 2 0.5 0.5 0.5\n# end\n");
        ASSERT_EQ(mesh.triangles.size(), 1u);
        EXPECT_EQ(mesh.normals[0], (Vec3f{0, 0, normal ? -1.0f : 1.0f}));
        ASSERT_EQ(mesh.textureCoordinates.size(), texture ? 3u : 0u);
        for (const Vec2f& t : mesh.textureCoordinates) EXPECT_EQ(t, (Vec2f{0.5f, 0.25f}));
        ASSERT_EQ(mesh.colours.size(), colour ? 3u : 0u);
        for (const Vec3f& c : mesh.colours) EXPECT_EQ(c, (Vec3f{1, 0, 0}));
        EXPECT_EQ(mesh.coloursAreIntegers, colour);
        EXPECT_TRUE(hasNote(mesh, "(colours of faces) ignored"));
      }
}

TEST(Off, SaysWhatComesAfterTheLastFace) {
  EXPECT_TRUE(hasNote(loadText("more.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n3 2 1 0\n"),
                      "2 lines after the last face ignored"));
}

TEST(Stl, AsciiInAnySpelling) {
  std::string shouted = "solid x\n" + kFacet + "endsolid x\n";
  for (char& c : shouted) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  for (const std::string& text : {shouted, "\n  solid\n" + kFacet + "endsolid\n",
                                  "\xef\xbb\xbfsolid\n" + kFacet + "endsolid", "\xef\xbb\xbf\n" + shouted}) {
    const Mesh mesh = loadText("any.stl", text);
    EXPECT_EQ(mesh.triangles.size(), 1u);
    EXPECT_TRUE(mesh.report.notes.empty());
  }
  EXPECT_TRUE(hasNote(loadText("open.stl", "solid\n" + kFacet), "no endsolid"));
}

TEST(Stl, BinaryThatBeginsWithSolid) {
  std::string bytes = "solid facet endsolid";
  bytes.resize(80, ' ');
  bytes += std::string("\1\0\0\0", 4) + std::string(12, '\0');
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
    bytes.append(reinterpret_cast<const char*>(&x), 4);
  bytes += std::string(2, '\0');
  EXPECT_EQ(loadText("solid.stl", bytes).report.format, "STL binary");
  EXPECT_NE(test::errorOf(test::writeScratch("solid.stl", bytes.substr(0, 120))).find("claims 1 triangles"),
            std::string::npos);
}

TEST(Stl, RefusesFacetsThatAreNoTriangles) {
  EXPECT_NE(test::errorOf(test::writeScratch("none.stl", "solid\nfacet normal 0 0 1\nendfacet\nendsolid\n"))
                .find("line 3: a facet without exactly three vertices"),
            std::string::npos);
  EXPECT_NE(test::errorOf(test::writeScratch("loose.stl", "solid\nvertex 0 0 0\nendsolid\n"))
                .find("line 2: a vertex outside any facet"),
            std::string::npos);
}

}  // namespace
}  // namespace shprt
