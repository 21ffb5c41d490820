#include "shprt/scene/merge_meshes.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "shprt/base/error.h"

namespace shprt {
namespace {

template <typename T>
void append(std::vector<T>& whole, const std::vector<T>& part) {
  whole.insert(whole.end(), part.begin(), part.end());
}

void addReport(MeshReport& sum, const MeshReport& part) {
  if (sum.format != part.format) sum.format = "several formats";
  for (const auto member :
       {&MeshReport::sourceVertices, &MeshReport::sourceFaces, &MeshReport::sourceTriangles,
        &MeshReport::nonFiniteVertices, &MeshReport::nonFiniteFaces, &MeshReport::badIndexFaces,
        &MeshReport::shortFaces, &MeshReport::zeroAreaTriangles, &MeshReport::unreferencedVertices,
        &MeshReport::generatedNormals})
    sum.*member += part.*member;
  sum.normalsFromFile = sum.normalsFromFile || part.normalsFromFile;
  append(sum.notes, part.notes);
}

}  // namespace

void appendMesh(Mesh& whole, Mesh part) {
  assert(whole.materials.empty() && part.materials.empty() && whole.colours.empty() && part.colours.empty());
  if (whole.positions.empty()) {
    whole = std::move(part);
    return;
  }
  const std::size_t first = whole.positions.size(), vertices = first + part.positions.size();
  if (std::max(vertices, 3 * (whole.triangles.size() + part.triangles.size())) >
      std::numeric_limits<std::uint32_t>::max())
    throw Error("scene", "has more vertices or triangles than 32-bit indices can name", "leave objects out");
  const bool textured = !whole.textureCoordinates.empty() || !part.textureCoordinates.empty();
  append(whole.positions, part.positions);
  append(whole.normals, part.normals);
  append(whole.vertexMaterials, part.vertexMaterials);
  if (textured) {
    whole.textureCoordinates.resize(first);
    append(whole.textureCoordinates, part.textureCoordinates);
    whole.textureCoordinates.resize(vertices);
  }
  whole.triangles.reserve(whole.triangles.size() + part.triangles.size());
  for (const auto& [a, b, c] : part.triangles) {
    const auto offset = static_cast<std::uint32_t>(first);
    whole.triangles.push_back({a + offset, b + offset, c + offset});
  }
  addReport(whole.report, part.report);
}

}  // namespace shprt
