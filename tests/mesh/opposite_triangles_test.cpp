// Triangles back to back.
#include <gtest/gtest.h>

#include "shprt/mesh/opposite_triangles.h"

namespace shprt {
namespace {

Mesh fiveCorners() {
  Mesh mesh;
  // Vertex 4 lies at vertex 0's place, spelt with a negative zero.
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {-0.0f, 0, 0}};
  mesh.normals.assign(5, {0, 0, 1});
  return mesh;
}

TEST(OppositeTriangles, AreFoundInWhateverOrderTheirCornersCome) {
  for (const Triangle& back : {Triangle{0, 2, 1}, Triangle{2, 1, 0}, Triangle{1, 4, 2}}) {
    Mesh mesh = fiveCorners();
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}, back};
    EXPECT_EQ(oppositeTriangles(mesh), (std::vector<std::uint32_t>{2, kNoTriangle, 0}));
  }
}

TEST(OppositeTriangles, TheSameSideTwiceIsNotOpposite) {
  Mesh mesh = fiveCorners();
  mesh.triangles = {{0, 1, 2}, {1, 2, 0}, {2, 4, 1}};
  EXPECT_EQ(oppositeTriangles(mesh), (std::vector<std::uint32_t>{kNoTriangle, kNoTriangle, kNoTriangle}));
}

TEST(OppositeTriangles, OfSeveralTheFirstIsTaken) {
  Mesh mesh = fiveCorners();
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}, {4, 2, 1}, {1, 2, 4}};
  EXPECT_EQ(oppositeTriangles(mesh), (std::vector<std::uint32_t>{1, 0, 0, 1}));
}

}  // namespace
}  // namespace shprt
