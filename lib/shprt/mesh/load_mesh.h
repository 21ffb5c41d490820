// Mesh files to render vertices: the front of the mesh room.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "shprt/mesh/mesh.h"

namespace shprt {

inline constexpr double kDefaultCreaseAngleDegrees = 60;

struct LoadMeshOptions {
  // When set, normals are computed (angle-weighted, edges sharper than this stay hard) even where the file
  // has some. When not, the file's normals are used, and missing ones computed with
  // kDefaultCreaseAngleDegrees.
  std::optional<double> creaseAngleDegrees;
};

struct LoadedMesh {
  Mesh mesh;
  std::vector<std::filesystem::path> sources;  // the mesh file first, then material files that were read
};

// Reads OBJ (with MTL), PLY, OFF or STL, decided by suffix (any case), else by content. Every face that has
// three distinct corners with finite, in-range positions and area is kept, however non-manifold, duplicate or
// flipped; all else is counted in mesh.report. Throws Error when nothing can be baked or when what is left
// cannot be told from the file (truncated, claims more than it holds, not a mesh).
LoadedMesh loadMesh(const std::filesystem::path& path, const LoadMeshOptions& options = {});

}  // namespace shprt
