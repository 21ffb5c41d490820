// A triangle mesh ready for baking: one render vertex per distinct (position, normal, texture coordinate,
// colour, material) that the faces use, so hard edges and seams stay as the file has them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

using Triangle = std::array<std::uint32_t, 3>;  // render-vertex indices, counter-clockwise seen from outside

struct Material {
  std::string name;            // "" for faces without a material
  Vec3f diffuse;               // linear Rec.709 albedo in [0,1]
  std::string diffuseTexture;  // file name as the MTL gives it, "" for none
  bool hasDiffuse = false;     // whether the file gives diffuse; otherwise the default albedo applies
  Vec3f emission;              // radiance, linear Rec.709, not negative
  std::string folder;          // of the MTL file, to which names of textures are relative
};

// Stands where a vertex of a mesh with colours has none.
inline constexpr Vec3f kNoColour{-1, -1, -1};

// What the loader found, left out and mended. Counts are of the source file's own elements.
struct MeshReport {
  std::string format;  // "OBJ", "PLY ascii", "PLY binary", "OFF", "OFF binary", "STL ascii", "STL binary"
  std::uint64_t sourceVertices = 0;  // vertex records (STL: distinct corner positions)
  std::uint64_t sourceFaces = 0;     // face records
  std::uint64_t sourceTriangles =
      0;  // triangles those faces make before any is left out: sum of (corners - 2)
  std::uint64_t nonFiniteVertices = 0;     // NaN, infinite, beyond float, or unreadable coordinates
  std::uint64_t nonFiniteFaces = 0;        // faces left out because they use such a vertex
  std::uint64_t badIndexFaces = 0;         // faces left out because an index is out of range or unreadable
  std::uint64_t shortFaces = 0;            // faces left out because they have fewer than 3 corners
  std::uint64_t zeroAreaTriangles = 0;     // triangles left out: repeated corners or no area
  std::uint64_t unreferencedVertices = 0;  // vertices no kept face uses
  std::uint64_t generatedNormals = 0;  // corners whose normal was computed (none in the file, or unusable)
  bool normalsFromFile = false;        // whether the file's normals were used at all
  std::vector<std::string>
      notes;  // one line each: what else was ignored or assumed (lines, elements, textures)
};

struct Mesh {
  std::vector<Vec3f> positions;           // per render vertex, file coordinates
  std::vector<Vec3f> normals;             // per render vertex, unit length
  std::vector<Vec2f> textureCoordinates;  // per render vertex, or empty when the file has none
  // Per render vertex as the file gives them, in [0,1], or kNoColour; empty when the file has none.
  std::vector<Vec3f> colours;
  bool coloursAreIntegers = false;             // stored as 0 to 255 or 65535: most likely sRGB; else linear
  std::vector<std::uint32_t> vertexMaterials;  // per render vertex, index into materials
  std::vector<Triangle> triangles;             // never degenerate
  std::vector<Material> materials;             // at least one
  MeshReport report;
};

}  // namespace shprt
