// Every mesh of shared/data ends in the counts of its manifest or in one clear error.
#include <map>

#include "tests/mesh/mesh_files.h"

namespace shprt {
namespace {

// Files that cannot be baked, with what the message must say.
const std::map<std::string, std::string> kRefused = {
    {"problem/empty.obj", "is empty"},
    {"problem/empty.off", "is empty"},
    {"problem/empty.ply", "is empty"},
    {"problem/face_in_group_name.obj", "has no faces"},
    {"problem/obj_points.obj", "has no faces"},
    {"problem/line-prim.obj", "has no faces"},
    {"problem/points_emptyface.ply", "has no faces"},
    {"problem/stl_empty_bin.stl", "has no faces"},
    {"problem/invalid-face-definition.obj", "2 under three corners"},
    {"problem/invalid-relative-vertex-index.obj", "1 bad index"},
    {"problem/number_formats.obj", "without area"},
    {"problem/lfs_pointer.obj", "git lfs pull"},
    {"problem/OutOfMemory.off", "more than its"},
    {"problem/easy3d_2_umbrellas_open.off", "claims 10 faces, the file ends after 8"},
    {"problem/ply_empty_header.ply", "no element 'vertex'"},
    {"problem/crash-30d6d0f7c529b3b66b4131700b7a4580cd7082df.ply", "unknown type"},
};

// Where this loader counts otherwise than the manifest's parser, and why.
struct Counts {
  std::uint64_t vertices, faces, triangles;
};
const std::map<std::string, Counts> kOwnCounts = {
    {"problem/igea.ply", {134345, 268686, 268686}},  // strips, which the manifest's parser skips
    {"problem/notenoughindices.obj", {3, 2, 1}},     // counts the face with too few corners too
    {"problem/fuze_ascii.ply", {502, 1000, 1000}},   // its lines are longer than its header says
    {"problem/whitespace.off", {8, 6, 12}},          // "OFF8 6 12" behind blanks
};

bool isMeshFile(const std::string& file) {
  for (const char* suffix : {".obj", ".ply", ".off", ".stl", ".STL"}) {
    if (file.ends_with(suffix)) return true;
  }
  return false;
}

TEST(SharedMeshes, LoadWithTheCountsOfTheManifestOrAClearError) {
  if (!std::filesystem::exists(SHPRT_SHARED_DIR "/data/MANIFEST.md"))
    GTEST_SKIP() << "SKIPPED: no meshes in " SHPRT_SHARED_DIR;
  int loaded = 0, refused = 0;
  for (const test::ManifestRow& row : test::readManifest()) {
    if (!isMeshFile(row.file)) continue;
    const std::string path = std::string(SHPRT_SHARED_DIR "/data/") + row.file;
    if (const auto expected = kRefused.find(row.file); expected != kRefused.end()) {
      EXPECT_NE(test::errorOf(path).find(expected->second), std::string::npos)
          << row.file << ": " << test::errorOf(path);
      ++refused;
      continue;
    }
    const auto own = kOwnCounts.find(row.file);
    ASSERT_TRUE(row.counted || own != kOwnCounts.end()) << row.file;
    const Counts expected =
        own != kOwnCounts.end() ? own->second : Counts{row.vertices, row.faces, row.triangles};
    const Mesh mesh = loadMesh(path).mesh;
    const MeshReport& report = mesh.report;
    EXPECT_EQ(report.sourceVertices, expected.vertices) << row.file;
    EXPECT_EQ(report.sourceFaces, expected.faces) << row.file;
    EXPECT_EQ(report.sourceTriangles, expected.triangles) << row.file;
    // Nothing vanishes: triangles are kept or counted. (Faces left out whole are counted as faces.)
    if (report.badIndexFaces + report.nonFiniteFaces == 0) {
      EXPECT_EQ(mesh.triangles.size() + report.zeroAreaTriangles, report.sourceTriangles) << row.file;
    }
    for (const Vec3f& normal : mesh.normals) ASSERT_NEAR(length(toDouble(normal)), 1, 1e-6) << row.file;
    for (const Triangle& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle) ASSERT_LT(corner, mesh.positions.size()) << row.file;
    ++loaded;
  }
  EXPECT_GT(loaded, 80);
  EXPECT_EQ(refused, static_cast<int>(kRefused.size()));
}

TEST(SharedMeshes, DefectsAreCountedAsTheManifestSays) {
  if (!std::filesystem::exists(SHPRT_SHARED_DIR "/data/MANIFEST.md"))
    GTEST_SKIP() << "SKIPPED: no meshes in " SHPRT_SHARED_DIR;
  const auto report = [](const char* file) {
    return loadMesh(std::string(SHPRT_SHARED_DIR "/data/") + file).mesh.report;
  };
  EXPECT_EQ(report("meshes/stanford-bunny.obj").unreferencedVertices, 1113u);
  EXPECT_EQ(report("meshes/ogre.obj").zeroAreaTriangles, 4u);
  EXPECT_EQ(report("meshes/202.obj").zeroAreaTriangles, 2u);
  EXPECT_EQ(report("meshes/plant/m_0_tree.001.ply").zeroAreaTriangles, 2910u);
  EXPECT_EQ(report("problem/bathtub.obj").zeroAreaTriangles, 19u);
  EXPECT_EQ(report("problem/Spider_binary.stl").zeroAreaTriangles, 56u);
  EXPECT_EQ(report("problem/CamelBox.stl").zeroAreaTriangles, 48u);
  EXPECT_EQ(report("problem/sliver_tet.ply").unreferencedVertices, 5005u);
  EXPECT_EQ(report("problem/bunny_nonmanifold.ply").unreferencedVertices, 25u);
  EXPECT_EQ(report("problem/test-nan.obj").nonFiniteVertices, 4u);
  EXPECT_EQ(report("problem/test-nan.obj").nonFiniteFaces, 1u);
  EXPECT_EQ(report("problem/malformed.obj").badIndexFaces, 2u);
  EXPECT_EQ(report("problem/malformed.obj").zeroAreaTriangles, 1u);
  EXPECT_EQ(report("problem/issue-140-zero-face-idx.obj").badIndexFaces, 1u);
}

}  // namespace
}  // namespace shprt
