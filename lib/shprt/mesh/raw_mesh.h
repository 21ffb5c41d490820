// Polygons as a file gives them, between parsing and render vertices.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/mesh/mesh.h"

namespace shprt {

// A file rewritten for OpenMesh's parser, with what only the judging of the original can tell. Faces left out
// of `bytes` are counted in report; vertices stay in place, unusable ones as zeros, so that no index shifts.
struct CanonicalFile {
  std::string bytes;
  std::string extension;  // of the dialect: "obj", "ply", "off", "stl"
  bool binary = false;
  std::uint64_t vertices = 0;              // that OpenMesh must deliver (STL: not known before it welds)
  std::uint64_t faces = 0;                 // that OpenMesh must deliver
  std::uint64_t corners = 0;               // of all those faces together
  std::vector<bool> unusableVertex;        // per vertex; empty when all are usable
  std::vector<std::uint32_t> duplicateOf;  // vertices appended beyond the file's own: which one each repeats
  std::vector<std::uint32_t> faceMaterials;  // per face, index into materials; empty when there are none
  // What the format's parser cannot deliver; else empty. A zero normal means none.
  std::vector<Vec3f> cornerNormals;
  std::vector<Vec2f> cornerTextureCoordinates;
  std::vector<Vec3f> vertexColours;  // per vertex of the file's own, in [0,1] or kNoColour
  bool coloursAreIntegers = false;
  std::vector<Material> materials;
  std::vector<std::filesystem::path> sources;  // further files that were read
  MeshReport report;
};

struct RawMesh {
  std::vector<Vec3f> positions;
  std::vector<std::uint32_t> faceStarts{0};  // corners of face f are faceStarts[f] to faceStarts[f+1]
  std::vector<std::uint32_t> corners;        // position indices
  // One per corner, or empty. A zero normal means none.
  std::vector<Vec3f> cornerNormals;
  std::vector<Vec2f> cornerTextureCoordinates;
  std::vector<Vec3f> vertexColours;  // per position, or empty

  std::size_t faceCount() const { return faceStarts.size() - 1; }
};

}  // namespace shprt
