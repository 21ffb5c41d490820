// Subdivision keeps shape, borders and attributes, and opens no cracks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <utility>

#include "shprt/base/error.h"
#include "shprt/mesh/load_mesh.h"
#include "shprt/mesh/subdivide.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

using Place = std::tuple<float, float, float>;

Place placeOf(const Mesh& mesh, std::uint32_t vertex) {
  const Vec3f p = mesh.positions[vertex];
  return {p.x, p.y, p.z};
}

// How many triangles run along each edge, in either direction.
std::map<std::pair<Place, Place>, int> edgeUses(const Mesh& mesh) {
  std::map<std::pair<Place, Place>, int> uses;
  for (const Triangle& triangle : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Place a = placeOf(mesh, triangle[i]), b = placeOf(mesh, triangle[(i + 1) % 3]);
      ++uses[std::minmax(a, b)];
    }
  return uses;
}

double borderLength(const Mesh& mesh) {
  double total = 0;
  for (const auto& [edge, uses] : edgeUses(mesh)) {
    if (uses != 1) continue;
    const auto vector = [](const Place& p) { return Vec3d{std::get<0>(p), std::get<1>(p), std::get<2>(p)}; };
    total += length(vector(edge.first) - vector(edge.second));
  }
  return total;
}

int eulerCharacteristic(const Mesh& mesh) {
  std::set<Place> places;
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t v : triangle) places.insert(placeOf(mesh, v));
  return static_cast<int>(places.size()) - static_cast<int>(edgeUses(mesh).size()) +
         static_cast<int>(mesh.triangles.size());
}

double areaOf(const Mesh& mesh, const Triangle& t) {
  const Vec3d a = toDouble(mesh.positions[t[0]]);
  return length(cross(toDouble(mesh.positions[t[1]]) - a, toDouble(mesh.positions[t[2]]) - a)) / 2;
}

double areaOf(const Mesh& mesh) {
  double area = 0;
  for (const Triangle& triangle : mesh.triangles) area += areaOf(mesh, triangle);
  return area;
}

double longestEdge(const Mesh& mesh) {
  const MeshEdges edges = findEdges(mesh);
  return *std::max_element(edges.lengths.begin(), edges.lengths.end());
}

void expectClosed(const Mesh& mesh, const std::string& what) {
  for (const auto& [edge, uses] : edgeUses(mesh)) ASSERT_EQ(uses, 2) << what;
}

// A third of the edges, whichever.
std::vector<bool> someEdges(const MeshEdges& edges, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<bool> marked(edges.lengths.size());
  for (std::size_t e = 0; e < marked.size(); ++e) marked[e] = random() % 3 == 0;
  return marked;
}

TEST(Subdivide, ClosedMeshesStayClosedWhicheverEdgesAreSplit) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    Mesh sphere = test::makeIcosphere(2), box = test::makeBox({-1, -1, -1}, {2, 2, 2}, 2);
    for (Mesh* mesh : {&sphere, &box}) {
      const double area = areaOf(*mesh);
      for (int level = 0; level < 3; ++level) {
        const MeshEdges edges = findEdges(*mesh);
        *mesh = splitEdges(*mesh, edges, someEdges(edges, seed + 10 * static_cast<unsigned>(level))).mesh;
        expectClosed(*mesh, "seed " + std::to_string(seed));
        EXPECT_EQ(eulerCharacteristic(*mesh), 2);
        EXPECT_NEAR(areaOf(*mesh), area, 1e-5 * area);
      }
    }
  }
}

TEST(Subdivide, KeepsAreaAndBorderOfAnOpenMesh) {
  Mesh sheet;
  test::addPatch(sheet, {0, 0, 0}, {3, 0, 0}, {0, 1, 0}, 2);
  const Subdivision fine = splitLongEdges(sheet, 0.1);
  EXPECT_LE(longestEdge(fine.mesh), 0.1);
  EXPECT_NEAR(areaOf(fine.mesh), 3, 1e-6);
  EXPECT_NEAR(borderLength(fine.mesh), 8, 1e-5);
  EXPECT_EQ(eulerCharacteristic(fine.mesh), 1);
  std::vector<double> areas(sheet.triangles.size());
  for (std::size_t t = 0; t < fine.mesh.triangles.size(); ++t)
    areas[fine.triangleParents[t]] += areaOf(fine.mesh, fine.mesh.triangles[t]);
  for (std::size_t t = 0; t < areas.size(); ++t)
    EXPECT_NEAR(areas[t], areaOf(sheet, sheet.triangles[t]), 1e-6)
        << "parts do not make up their parent " << t;
}

TEST(Subdivide, LeavesFineMeshesAsTheyAre) {
  const Mesh sphere = test::makeIcosphere(2);
  const Subdivision same = splitLongEdges(sphere, 1);
  EXPECT_EQ(same.mesh.positions, sphere.positions);
  EXPECT_EQ(same.mesh.triangles, sphere.triangles);
  EXPECT_TRUE(same.vertexParents.empty());
}

TEST(Subdivide, SplitsEdgesInHalvesOfEqualTrianglesExactly) {
  Mesh triangle;
  triangle.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  triangle.normals.assign(3, Vec3f{0, 0, 1});
  triangle.triangles = {{0, 1, 2}};
  // The long side is 4 sqrt 2: two levels bring every side to at most sqrt 2, in 16 equal parts.
  const Mesh fine = splitLongEdges(triangle, 1.5).mesh;
  ASSERT_EQ(fine.triangles.size(), 16u);
  for (const Triangle& part : fine.triangles) EXPECT_EQ(areaOf(fine, part), 0.5);
  EXPECT_EQ(fine.positions.size(), 15u);
}

TEST(Subdivide, AttributesAreLinearAndParentsComeFirst) {
  Mesh mesh = test::makeBox({0, 0, 0}, {1, 2, 3}, 1);
  const auto affine = [](Vec3f p, float a, float b, float c) { return a * p.x + b * p.y + c * p.z; };
  for (const Vec3f& p : mesh.positions) {
    mesh.textureCoordinates.push_back({affine(p, 1, 0.5f, -0.25f), affine(p, -0.5f, 2, 1)});
    mesh.colours.push_back({affine(p, 0.5f, 0, 0), affine(p, 0, 0.25f, 0), affine(p, 0, 0, 0.25f)});
  }
  mesh.vertexMaterials.assign(mesh.positions.size(), 0);
  for (std::size_t v = 0; v < 4; ++v) mesh.vertexMaterials[v] = 1;  // one face
  const Subdivision fine = splitLongEdges(mesh, 0.4);
  const Mesh& m = fine.mesh;
  ASSERT_EQ(m.positions.size(), mesh.positions.size() + fine.vertexParents.size());
  for (std::uint32_t v = 0; v < m.positions.size(); ++v) {
    const Vec3f p = m.positions[v];
    EXPECT_NEAR(m.textureCoordinates[v].x, affine(p, 1, 0.5f, -0.25f), 1e-5);
    EXPECT_NEAR(m.textureCoordinates[v].y, affine(p, -0.5f, 2, 1), 1e-5);
    EXPECT_NEAR(m.colours[v].y, affine(p, 0, 0.25f, 0), 1e-5);
    EXPECT_EQ(m.vertexMaterials[v], m.normals[v] == mesh.normals[0] ? 1u : 0u);
    EXPECT_NEAR(length(toDouble(m.normals[v])), 1, 1e-6);
    if (v < mesh.positions.size()) continue;
    const auto [a, b] = fine.vertexParents[v - mesh.positions.size()];
    EXPECT_LT(std::max(a, b), v);
    EXPECT_EQ(p, toFloat((toDouble(m.positions[a]) + toDouble(m.positions[b])) * 0.5));
  }
}

TEST(Subdivide, NormalsBetweenSmoothOnesAreTheirMeansAndOppositeOnesGiveTheFront) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  mesh.normals = {{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}};
  const MeshEdges edges = findEdges(mesh);
  const Subdivision fine = splitEdges(mesh, edges, std::vector<bool>(3, true));
  const auto r = static_cast<float>(std::sqrt(0.5));
  EXPECT_EQ(fine.mesh.normals[3], (Vec3f{0, 0, 1}));
  EXPECT_NEAR(length(toDouble(fine.mesh.normals[4]) - Vec3d{-r, 0, r}), 0, 1e-6);
  EXPECT_NEAR(length(toDouble(fine.mesh.normals[5]) - Vec3d{r, 0, r}), 0, 1e-6);
}

// Far from the origin, where midpoints are rounded, and with edges of odd lengths.
Mesh awkwardSheet() {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> jitter(-0.3f, 0.3f);
  Mesh sheet;
  test::addPatch(sheet, {1000.1, -333.3, 77.7}, {4, 0.3, 0.1}, {-0.2, 4, 0.7}, 4);
  for (Vec3f& p : sheet.positions) p += Vec3f{jitter(random), jitter(random), jitter(random)};
  return sheet;
}

TEST(Subdivide, TwinsAreCutAlike) {
  const Mesh front = awkwardSheet();
  Mesh back = front;
  for (Vec3f& n : back.normals) n = -n;
  for (Triangle& t : back.triangles) t = {t[2], t[1], t[0]};
  Mesh both = front;
  test::append(both, back);
  const MeshEdges edges = findEdges(both);
  std::vector<Mesh> results;
  for (unsigned seed = 0; seed < 8; ++seed)
    results.push_back(splitEdges(both, edges, someEdges(edges, seed)).mesh);
  results.push_back(splitLongEdges(both, 0.2).mesh);
  for (const Mesh& fine : results) {
    std::multiset<std::array<Place, 3>> fronts, backs;
    const Vec3f up = front.normals[0];
    for (const Triangle& t : fine.triangles) {
      std::array<Place, 3> places = {placeOf(fine, t[0]), placeOf(fine, t[1]), placeOf(fine, t[2])};
      std::sort(places.begin(), places.end());
      (fine.normals[t[0]] == up ? fronts : backs).insert(places);
    }
    EXPECT_GT(fronts.size(), front.triangles.size());
    EXPECT_EQ(fronts, backs);
  }
}

TEST(Subdivide, SeamsStayClosed) {
  // Two halves of a sheet with nothing but positions in common.
  const Mesh sheet = awkwardSheet();
  Mesh torn;
  torn.textureCoordinates.clear();
  for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
    const auto first = static_cast<std::uint32_t>(torn.positions.size());
    for (const std::uint32_t v : sheet.triangles[t]) {
      torn.positions.push_back(sheet.positions[v]);
      torn.normals.push_back(sheet.normals[v]);
      torn.textureCoordinates.push_back({static_cast<float>(t), 0});
    }
    torn.triangles.push_back({first, first + 1, first + 2});
  }
  const MeshEdges edges = findEdges(sheet), tornEdges = findEdges(torn);
  ASSERT_EQ(edges.lengths, tornEdges.lengths);
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Mesh whole = splitEdges(sheet, edges, someEdges(edges, seed)).mesh,
               fine = splitEdges(torn, tornEdges, someEdges(edges, seed)).mesh;
    EXPECT_EQ(edgeUses(fine), edgeUses(whole)) << "torn and whole sheets are cut differently";
    EXPECT_GT(fine.positions.size(), torn.positions.size());
  }
}

TEST(Subdivide, OnlyWantedTrianglesAreSplitAndNeighboursFollow) {
  Mesh sheet;
  test::addPatch(sheet, {0, 0, 0}, {4, 0, 0}, {0, 1, 0}, 4, 1, {0, 0, 1});
  std::vector<bool> wanted(sheet.triangles.size());
  wanted[0] = wanted[1] = true;  // the first cell
  const Subdivision fine = splitLongEdges(sheet, 0.3, wanted);
  std::vector<int> parts(sheet.triangles.size());
  for (const std::uint32_t parent : fine.triangleParents) ++parts[parent];
  EXPECT_GE(parts[0], 16);
  EXPECT_GT(std::max(parts[2], parts[3]), 1) << "the neighbour shares a split edge";
  for (std::size_t t = 4; t < parts.size(); ++t) EXPECT_EQ(parts[t], 1);
  for (const auto& [edge, uses] : edgeUses(fine.mesh)) {
    const bool border = std::get<1>(edge.first) == std::get<1>(edge.second) ||
                        std::get<0>(edge.first) == std::get<0>(edge.second);
    EXPECT_TRUE(uses == 2 || border);
  }
  EXPECT_NEAR(borderLength(fine.mesh), 10, 1e-5) << "a hanging vertex would count as a border";
}

TEST(Subdivide, LongestEdgesFirstKeepAngles) {
  // Splitting one side alone, ever again, would leave nothing but needles from it to the corner opposite.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {5, 0, 0}, {1, 3, 0}};
  mesh.normals.assign(3, Vec3f{0, 0, 1});
  mesh.triangles = {{0, 1, 2}};
  const auto smallestAngle = [](const Mesh& m) {
    double smallest = 4;
    for (const Triangle& t : m.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d p = toDouble(m.positions[t[i]]), u = toDouble(m.positions[t[(i + 1) % 3]]) - p,
                    v = toDouble(m.positions[t[(i + 2) % 3]]) - p;
        smallest = std::min(smallest, std::atan2(length(cross(u, v)), dot(u, v)));
      }
    return smallest;
  };
  const double before = smallestAngle(mesh);
  for (int level = 0; level < 8; ++level) {
    const MeshEdges edges = findEdges(mesh);
    std::vector<bool> marked(edges.lengths.size());
    for (std::size_t e = 0; e < marked.size(); ++e)
      marked[e] = mesh.positions[edges.ends[e][0]].y == 0 && mesh.positions[edges.ends[e][1]].y == 0;
    markLongestEdges(edges, marked);
    mesh = splitEdges(mesh, edges, marked).mesh;
  }
  EXPECT_GE(smallestAngle(mesh), 0.499 * before);
  EXPECT_LT(mesh.triangles.size(), 16u * 256) << "a few for each of the 256 parts of that side";
}

TEST(Subdivide, CountsWithoutMakingTriangles) {
  Mesh slivers;
  test::addPatch(slivers, {0, 0, 0}, {8, 0, 0}, {0, 0.125, 0}, 1);
  const Mesh meshes[] = {test::makeIcosphere(0), awkwardSheet(), slivers};
  for (const Mesh& mesh : meshes)
    for (const double longest : {1.5, 0.4, 0.1}) {
      const double counted = countSplitTriangles(mesh, longest, {}, 1'000'000);
      EXPECT_EQ(counted, static_cast<double>(splitLongEdges(mesh, longest).mesh.triangles.size()));
    }
}

TEST(Subdivide, RefusesToExplode) {
  const Mesh sphere = test::makeIcosphere(1);
  for (const double longest : {1e-5, 1e-30}) {
    try {
      splitLongEdges(sphere, longest);
      FAIL() << "no error";
    } catch (const Error& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find("--max-edge"), std::string::npos) << what;
      EXPECT_NE(what.find(std::to_string(kMaxRefinedTriangles)), std::string::npos) << what;
    }
  }
  EXPECT_THROW(splitLongEdges(sphere, 0.1, {}, 1000), Error);
  EXPECT_THROW(splitLongEdges(sphere, 0), Error);
  EXPECT_THROW(splitLongEdges(sphere, -1), Error);
  EXPECT_THROW(splitLongEdges(sphere, std::numeric_limits<double>::quiet_NaN()), Error);
}

TEST(Subdivide, EdgesOfAFewFloatStepsAreLeftWhole) {
  // Near 1e6 floats are 1/16 apart: edges can be halved a few times, then there is nothing between their
  // ends.
  Mesh mesh = test::moved(test::makeIcosphere(1), 1, {1e6, 1e6, 1e6});
  std::erase_if(mesh.triangles, [&](const Triangle& t) { return !(areaOf(mesh, t) > 0); });
  const Mesh fine = splitLongEdges(mesh, 1e-2).mesh;
  EXPECT_GT(fine.triangles.size(), mesh.triangles.size());
  for (const Triangle& t : fine.triangles) ASSERT_GT(areaOf(fine, t), 0);
  // Places that round to one are one, so an edge may have four triangles, but none loses its neighbour.
  for (const auto& [edge, uses] : edgeUses(fine)) ASSERT_EQ(uses % 2, 0);
}

TEST(Subdivide, KnotOfTheProject) {
  const Mesh knot = loadMesh(SHPRT_SOURCE_DIR "/data/knot.ply").mesh;
  const double longest = longestEdge(knot);
  const Mesh fine = splitLongEdges(knot, 0.4 * longest).mesh;
  EXPECT_LE(longestEdge(fine), 0.4 * longest);
  EXPECT_EQ(eulerCharacteristic(fine), 0 + 1) << "a torus and a disc";
  EXPECT_NEAR(borderLength(fine), borderLength(knot), 1e-4 * borderLength(knot));
  EXPECT_NEAR(areaOf(fine), areaOf(knot), 1e-5 * areaOf(knot));
}

}  // namespace
}  // namespace shprt
