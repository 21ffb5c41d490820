// Judging a mesh file before OpenMesh parses it.
//
// OpenMesh's parsers report success on broken input, drop lines so that later indices shift, follow the
// global locale and trust counts. So each format has a preflight: it checks the file against itself, counts
// what cannot be used, and rewrites the rest into the plain dialect that OpenMesh reads without surprises.
// What OpenMesh then delivers is compared with what the preflight counted.
#pragma once

#include <filesystem>
#include <string>

#include "shprt/mesh/raw_mesh.h"

namespace shprt {

// bytes: the whole file, consumed. All throw Error for what cannot be told from the file.
CanonicalFile preflightObj(const std::filesystem::path& path, std::string bytes);
CanonicalFile preflightPly(const std::filesystem::path& path, std::string bytes);
CanonicalFile preflightOff(const std::filesystem::path& path, std::string bytes);
CanonicalFile preflightStl(const std::filesystem::path& path, std::string bytes);

// Collects the faces that a preflight keeps: checks indices, counts what it leaves out, and makes corners
// distinct, because OpenMesh removes a vertex that a face names twice (as polygons with a bridge to a hole
// do).
class FaceFilter {
 public:
  FaceFilter(std::uint64_t vertexCount, CanonicalFile& file) : vertexCount_(vertexCount), file_(file) {}

  // Corner indices of one face, any of them out of range (negative counts as such). Returns false, counting
  // why, when the face is left out; else corners are in range, and distinct: repeats refer to appended
  // vertices.
  bool keep(std::vector<std::int64_t>& corners);

 private:
  void separateRepeats(std::vector<std::int64_t>& corners);

  std::uint64_t vertexCount_;
  CanonicalFile& file_;
};

// "3 things" or "1 thing": for notes.
std::string countOf(std::uint64_t count, const std::string& thing, const std::string& things = "");

}  // namespace shprt
