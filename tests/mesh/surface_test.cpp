// Surfaces: polygons cut without loss, normals that fit the shape wherever and however large it is.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>

#include "shprt/mesh/text.h"
#include "shprt/mesh/triangulate.h"
#include "tests/mesh/mesh_files.h"

namespace shprt {
namespace {

using test::loadText;

TEST(Triangulate, CollinearCornersStayInTriangles) {
  // A rectangle with corners on its sides, from every start: no triangle without area, and every corner used.
  const std::vector<Vec3d> outline = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0},
                                      {3, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  for (std::size_t start = 0; start < outline.size(); ++start) {
    std::vector<Vec3d> corners;
    for (std::size_t i = 0; i < outline.size(); ++i) corners.push_back(outline[(start + i) % outline.size()]);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    TriangulationBudget budget;
    EXPECT_TRUE(triangulate(corners, triangles, budget));
    ASSERT_EQ(triangles.size(), corners.size() - 2);
    std::vector<bool> used(corners.size());
    double area = 0;
    for (const auto& [a, b, c] : triangles) {
      const double twice = cross(corners[b] - corners[a], corners[c] - corners[a]).z;
      EXPECT_GT(twice, 0);
      area += twice / 2;
      used[a] = used[b] = used[c] = true;
    }
    EXPECT_EQ(area, 6);
    EXPECT_EQ(std::count(used.begin(), used.end(), true), 8);
  }
}

double areaOf(const std::vector<Vec3d>& outline) {
  Vec3d twice;
  for (std::size_t i = 0; i < outline.size(); ++i)
    twice += cross(outline[i] - outline[0], outline[(i + 1) % outline.size()] - outline[0]);
  return length(twice) / 2;
}

double areaOf(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    std::vector<Vec3d> corners;
    for (const std::uint32_t corner : t) corners.push_back(toDouble(mesh.positions[corner]));
    sum += areaOf(corners);
  }
  return sum;
}

TEST(Triangulate, BridgesAndSpikesAddNoSurface) {
  // Two squares joined by a bridge that is walked there and back, a spike inwards, one outwards, and a
  // repeated corner, from every start: triangles that are not turned over and add up to the two squares cover
  // them.
  const std::vector<Vec3d> outline = {
      {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {4, 1, 0}, {3.5, 1, 0}, {3.5, 0.5, 0}, {3.5, 1, 0}, {3, 1, 0},
      {3, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 2, 0},   {1, 1, 0},     {1, 1, 0},   {1, 0, 0}};
  for (std::size_t start = 0; start < outline.size(); ++start) {
    std::vector<Vec3d> corners;
    for (std::size_t i = 0; i < outline.size(); ++i) corners.push_back(outline[(start + i) % outline.size()]);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    TriangulationBudget budget;
    EXPECT_TRUE(triangulate(corners, triangles, budget));
    ASSERT_EQ(triangles.size(), corners.size() - 2);
    double area = 0;
    for (const auto& [a, b, c] : triangles) {
      const double twice = cross(corners[b] - corners[a], corners[c] - corners[a]).z;
      EXPECT_GE(twice, 0) << start;
      area += twice / 2;
    }
    EXPECT_EQ(area, 2) << start;
  }
}

TEST(SharedMeshes, PolygonsKeepTheirArea) {
  const std::string folder = SHPRT_SHARED_DIR "/data/problem/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "SKIPPED: no " << folder;
  for (const char* file :
       {"wallhole.obj", "issue-319-002.obj", "concave_polygon.obj", "platonic_shelf.obj"}) {
    std::ifstream in(folder + file);
    std::vector<Vec3d> places;
    double expected = 0;
    for (std::string line, more; std::getline(in, line);) {
      // The walls continue their lines, and end them in two characters.
      for (std::erase(line, '\r'); line.ends_with('\\') && std::getline(in, more); std::erase(line, '\r'))
        line.back() = ' ', line += more;
      std::istringstream words(line);
      std::string word;
      words >> word;
      if (word == "v") {
        Vec3d p;
        words >> p.x >> p.y >> p.z;
        places.push_back(p);
      } else if (word == "f") {
        std::vector<Vec3d> outline;
        while (words >> word && std::isdigit(static_cast<unsigned char>(word[0])))
          outline.push_back(places.at(std::stoul(word) - 1));
        expected += areaOf(outline);
      }
    }
    // Positions are rounded to float, and a flat polygon's corners with them.
    EXPECT_NEAR(areaOf(loadMesh(folder + file).mesh), expected, 1e-5 * expected) << file;
  }
  // Two rectangles of 0.038172 by 0.087448, joined by a bridge without width.
  EXPECT_NEAR(areaOf(loadMesh(folder + "easy3d_complex_face_1.off").mesh), 2 * 0.038172 * 0.087448, 1e-8);
}

TEST(Triangulate, AMeshHasOneBudget) {
  // Crossing polygons use it up; what comes after is cut as it comes, and still completely.
  std::vector<Vec3d> chaos;
  for (int i = 0; i < 300; ++i) chaos.push_back({std::sin(12.9 * i), std::cos(78.2 * i), 0});
  TriangulationBudget budget{100'000};
  std::vector<std::array<std::uint32_t, 3>> triangles;
  EXPECT_FALSE(triangulate(chaos, triangles, budget));
  EXPECT_EQ(budget.testsLeft, 0u);
  EXPECT_FALSE(triangulate(chaos, triangles, budget));
  EXPECT_EQ(triangles.size(), 2 * (chaos.size() - 2));
}

TEST(LoadMesh, FacesOfManyRepeatedCornersEnd) {
  // Every vertex twice: 10,000 corners that must be told apart and lie on each other.
  constexpr int kCount = 5000;
  std::string text = "OFF\n" + std::to_string(kCount) + " 1 0\n", indices;
  for (int i = 0; i < kCount; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCount;
    text += std::to_string(1000 * std::cos(angle)) + " " + std::to_string(1000 * std::sin(angle)) + " 0\n";
    indices += " " + std::to_string(i);
  }
  const Mesh mesh = loadText("large.off", text + std::to_string(2 * kCount) + indices + indices + "\n");
  EXPECT_EQ(mesh.report.sourceVertices, static_cast<std::uint64_t>(kCount));
  EXPECT_EQ(mesh.triangles.size() + mesh.report.zeroAreaTriangles, 2u * kCount - 2);
}

struct Sphere {
  std::vector<Vec3f> positions;
  std::vector<Triangle> triangles;
};

// An octahedron, each face cut into n^2 triangles and blown up to the unit sphere: 4 n^2 + 2 places.
Sphere octasphere(int n) {
  Sphere sphere;
  for (const float sx : {1.f, -1.f})
    for (const float sy : {1.f, -1.f})
      for (const float sz : {1.f, -1.f}) {
        const auto place = [&](int i, int j) {
          const int k = n - i - j;
          const float r = std::sqrt(static_cast<float>(i * i + j * j + k * k));
          sphere.positions.push_back({sx * static_cast<float>(i) / r, sy * static_cast<float>(j) / r,
                                      sz * static_cast<float>(k) / r});
          return static_cast<std::uint32_t>(sphere.positions.size() - 1);
        };
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
          sphere.triangles.push_back(sx * sy * sz > 0 ? Triangle{a, b, c} : Triangle{a, c, b});
        };
        for (int i = 0; i < n; ++i)
          for (int j = 0; i + j < n; ++j) {
            add(place(i, j), place(i + 1, j), place(i, j + 1));
            if (i + j + 1 < n) add(place(i + 1, j), place(i + 1, j + 1), place(i, j + 1));
          }
      }
  return sphere;
}

TEST(Normals, SoupOfASphereIsWeldedSmooth) {
  constexpr int kCuts = 12;
  const Sphere sphere = octasphere(kCuts);
  std::string stl(80, ' ');
  const auto count = static_cast<std::uint32_t>(sphere.triangles.size());
  stl.append(reinterpret_cast<const char*>(&count), 4);
  for (const Triangle& triangle : sphere.triangles) {
    stl += std::string(12, '\0');
    for (const std::uint32_t corner : triangle)
      stl.append(reinterpret_cast<const char*>(&sphere.positions[corner]), 12);
    stl += std::string(2, '\0');
  }
  const Mesh mesh = loadText("sphere.stl", stl);
  EXPECT_EQ(mesh.triangles.size(), 8u * kCuts * kCuts);
  EXPECT_EQ(mesh.positions.size(), 4u * kCuts * kCuts + 2);  // -0 and 0 are one place
  // Edges of 1/kCuts turn a face normal by about half of that; the mean over a fan is better by symmetry.
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_GT(dot(toDouble(mesh.normals[v]), toDouble(mesh.positions[v])), 1 - 1.0 / (8 * kCuts * kCuts));
}

TEST(Normals, DoNotDependOnPlaceOrSize) {
  const Sphere sphere = octasphere(2);
  const auto load = [&](double size, double offset) {
    std::string text;
    for (const Vec3f& p : sphere.positions) {
      text += "v";
      for (const double x : {p.x, p.y, p.z}) {
        // Quarters, so that the offset rounds nothing away.
        text += ' ';
        appendFloat(text, static_cast<float>(size * (std::round(4 * x) / 4 + offset)));
      }
      text += '\n';
    }
    for (const Triangle& t : sphere.triangles)
      text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
              std::to_string(t[2] + 1) + "\n";
    return loadText("moved.obj", text);
  };
  const Mesh still = load(1, 0);
  for (const auto& [size, offset] :
       {std::pair{0x1p-99, 0.0}, {0x1p+99, 0.0}, {1.0, 0x1p+20}, {0x1p-60, 0x1p+20}}) {
    const Mesh moved = load(size, offset);
    ASSERT_EQ(moved.normals.size(), still.normals.size());
    for (std::size_t v = 0; v < still.normals.size(); ++v) EXPECT_EQ(moved.normals[v], still.normals[v]);
  }
}

TEST(Normals, FlippedFacesKeepTheirOwnSide) {
  const std::string path = SHPRT_SHARED_DIR "/data/problem/conrod.off";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "SKIPPED: no " << path;
  const Mesh mesh = loadMesh(path).mesh;
  std::size_t against = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3d a = toDouble(mesh.positions[t[0]]), b = toDouble(mesh.positions[t[1]]),
                c = toDouble(mesh.positions[t[2]]);
    for (const std::uint32_t corner : t)
      against += !(dot(areaDirection(a, b, c), toDouble(mesh.normals[corner])) > 0);
  }
  EXPECT_EQ(against, 0u);
}

}  // namespace
}  // namespace shprt
