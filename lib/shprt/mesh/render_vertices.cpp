#include "shprt/mesh/render_vertices.h"

#include <algorithm>
#include <numeric>

#include "shprt/mesh/corner_normals.h"
#include "shprt/mesh/distinct.h"
#include "shprt/mesh/material_library.h"
#include "shprt/mesh/position_ids.h"
#include "shprt/mesh/preflight.h"
#include "shprt/mesh/triangulate.h"

namespace shprt {
namespace {

struct Triangles {
  std::vector<std::array<std::uint32_t, 3>> corners;  // indices into raw.corners
  std::vector<std::uint32_t> faces;
};

// All triangles with area, in file order.
Triangles cutFaces(const RawMesh& raw, std::span<const std::uint32_t> welded, MeshReport& report) {
  Triangles kept;
  kept.corners.reserve(raw.corners.size() - 2 * raw.faceCount());
  kept.faces.reserve(kept.corners.capacity());
  std::vector<Vec3d> polygon;
  std::vector<std::array<std::uint32_t, 3>> local;
  std::uint64_t unfinished = 0;
  TriangulationBudget budget;
  for (std::size_t face = 0; face < raw.faceCount(); ++face) {
    const std::uint32_t begin = raw.faceStarts[face], end = raw.faceStarts[face + 1];
    polygon.clear();
    for (std::uint32_t c = begin; c < end; ++c) polygon.push_back(toDouble(raw.positions[raw.corners[c]]));
    local.clear();
    if (!triangulate(polygon, local, budget)) ++unfinished;
    for (const auto& [a, b, c] : local) {
      const std::uint32_t pa = welded[raw.corners[begin + a]], pb = welded[raw.corners[begin + b]],
                          pc = welded[raw.corners[begin + c]];
      const bool repeated = pa == pb || pb == pc || pc == pa;
      if (repeated || areaDirection(polygon[a], polygon[b], polygon[c]) == Vec3d{}) {
        ++report.zeroAreaTriangles;
        continue;
      }
      kept.corners.push_back({begin + a, begin + b, begin + c});
      kept.faces.push_back(static_cast<std::uint32_t>(face));
    }
  }
  if (unfinished)
    report.notes.push_back(countOf(unfinished, "polygon") +
                           " with very many or crossing corners cut roughly");
  return kept;
}

// The normal of each kept triangle corner: the file's where it is usable, else computed.
std::vector<Vec3f> chooseNormals(const RawMesh& raw, const Triangles& kept,
                                 std::span<const std::uint32_t> welded, double creaseAngleDegrees,
                                 bool recompute, MeshReport& report) {
  std::vector<Vec3f> normals(3 * kept.corners.size());
  std::uint64_t missing = normals.size();
  if (!recompute && !raw.cornerNormals.empty()) {
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const Vec3d normal = normalize(toDouble(raw.cornerNormals[kept.corners[i / 3][i % 3]]));
      if (normal == Vec3d{} || !isFinite(normal)) continue;
      normals[i] = toFloat(normal);
      --missing;
    }
  }
  report.generatedNormals = missing;
  report.normalsFromFile = missing < normals.size();
  if (missing == 0) return normals;
  std::vector<Triangle> triangles;
  triangles.reserve(kept.corners.size());
  // Welded positions, each under the first raw index that has it.
  std::vector<std::uint32_t> firstUse;
  for (std::uint32_t i = 0; i < welded.size(); ++i) {
    if (welded[i] == firstUse.size()) firstUse.push_back(i);
  }
  for (const auto& corners : kept.corners) {
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = firstUse[welded[raw.corners[corners[k]]]];
    triangles.push_back(triangle);
  }
  const std::vector<Vec3f> computed = computeCornerNormals(raw.positions, triangles, creaseAngleDegrees);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (normals[i] == Vec3f{}) normals[i] = computed[i];
  }
  return normals;
}

}  // namespace

Mesh makeRenderVertices(const RawMesh& raw, const CanonicalFile& file, double creaseAngleDegrees,
                        bool recompute) {
  Mesh mesh;
  mesh.report = file.report;
  const std::vector<std::uint32_t> welded = distinctPositionIds(raw.positions);
  const Triangles kept = cutFaces(raw, welded, mesh.report);
  const std::vector<Vec3f> normals =
      chooseNormals(raw, kept, welded, creaseAngleDegrees, recompute, mesh.report);
  const bool textured = !raw.cornerTextureCoordinates.empty();
  const auto rawCorner = [&](std::size_t i) { return kept.corners[i / 3][i % 3]; };
  const auto textureOf = [&](std::size_t i) {
    return textured ? raw.cornerTextureCoordinates[rawCorner(i)] : Vec2f{};
  };
  const auto materialOf = [&](std::size_t i) {
    return file.faceMaterials.empty() ? kNoMaterial : file.faceMaterials[kept.faces[i / 3]];
  };

  const std::vector<std::uint32_t> colourIds = distinctPositionIds(raw.vertexColours);
  const bool coloured = !colourIds.empty();
  mesh.coloursAreIntegers = coloured && file.coloursAreIntegers;

  const DistinctIds distinct = numberDistinct<8>(normals.size(), [&](std::size_t i) {
    const Vec3f n = normals[i];
    const Vec2f t = textureOf(i);
    return std::array{welded[raw.corners[rawCorner(i)]],
                      keyBits(n.x),
                      keyBits(n.y),
                      keyBits(n.z),
                      keyBits(t.x),
                      keyBits(t.y),
                      materialOf(i),
                      coloured ? colourIds[raw.corners[rawCorner(i)]] : 0};
  });
  std::vector<std::uint32_t> materialNumbers(file.materials.size() + 1,
                                             kNoMaterial);  // the last: no material
  for (const std::uint32_t i : distinct.firstUse) {
    mesh.positions.push_back(raw.positions[raw.corners[rawCorner(i)]]);
    mesh.normals.push_back(normals[i]);
    if (textured) mesh.textureCoordinates.push_back(textureOf(i));
    if (coloured) mesh.colours.push_back(raw.vertexColours[raw.corners[rawCorner(i)]]);
    const std::uint32_t material =
        std::min<std::uint32_t>(materialOf(i), static_cast<std::uint32_t>(file.materials.size()));
    if (materialNumbers[material] == kNoMaterial) {
      materialNumbers[material] = static_cast<std::uint32_t>(mesh.materials.size());
      mesh.materials.push_back(material < file.materials.size() ? file.materials[material] : Material{});
    }
    mesh.vertexMaterials.push_back(materialNumbers[material]);
  }
  mesh.triangles.resize(kept.corners.size());
  for (std::size_t i = 0; i < distinct.ids.size(); ++i) mesh.triangles[i / 3][i % 3] = distinct.ids[i];

  std::vector<bool> used(raw.positions.size());
  for (const auto& corners : kept.corners)
    for (const std::uint32_t corner : corners) used[raw.corners[corner]] = true;
  for (std::size_t i = 0; i < file.duplicateOf.size(); ++i) {
    if (used[raw.positions.size() - file.duplicateOf.size() + i]) used[file.duplicateOf[i]] = true;
  }
  used.resize(raw.positions.size() - file.duplicateOf.size());
  const auto usedCount = static_cast<std::uint64_t>(std::count(used.begin(), used.end(), true));
  mesh.report.unreferencedVertices =
      mesh.report.sourceVertices - std::min(usedCount, mesh.report.sourceVertices);
  return mesh;
}

}  // namespace shprt
