#include "shprt/mesh/load_mesh.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/mesh/openmesh_import.h"
#include "shprt/mesh/preflight.h"
#include "shprt/mesh/render_vertices.h"
#include "shprt/mesh/text.h"
#include "shprt/mesh/text_encoding.h"

namespace shprt {
namespace {

using Preflight = CanonicalFile (*)(const std::filesystem::path&, std::string);

char lower(unsigned char c) {
  return static_cast<char>(std::tolower(c));
}

Preflight choosePreflight(const std::filesystem::path& path, std::string_view bytes) {
  std::string suffix = path.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), lower);
  if (suffix == ".obj") return preflightObj;
  if (suffix == ".ply") return preflightPly;
  if (suffix == ".off") return preflightOff;
  if (suffix == ".stl") return preflightStl;
  std::string_view head = bytes.substr(0, 4096);
  if (head.starts_with("ply")) return preflightPly;
  if (head.starts_with("solid")) return preflightStl;
  const std::string_view firstLine = takeLine(head);
  if (firstLine.find("OFF") != std::string_view::npos && firstLine.size() < 24) return preflightOff;
  throw Error(path.string(), "is of no mesh format that is known here",
              "give an .obj, .ply, .off or .stl file");
}

}  // namespace

LoadedMesh loadMesh(const std::filesystem::path& path, const LoadMeshOptions& options) {
  std::string bytes = readFile(path);
  if (bytes.empty()) throw Error(path.string(), "is empty", "give a mesh file");
  if (isLfsPointer(bytes))
    throw Error(path.string(), "is a git-LFS pointer, not a mesh", "fetch it with: git lfs pull");
  std::vector<std::string> notes;
  const Preflight preflight = choosePreflight(path, bytes);
  if (preflight == preflightObj || preflight == preflightOff) {
    bytes = decodeText(std::move(bytes), notes);
  } else {
    // PLY and STL may be binary: they are decoded only when that brings their first word to light.
    std::vector<std::string> ignored;
    std::string head = decodeText(bytes.substr(0, 64), ignored);
    head.erase(0, head.find_first_not_of(" \t\r\n"));
    std::transform(head.begin(), head.end(), head.begin(), lower);
    if (head.starts_with("ply") || head.starts_with("solid")) bytes = decodeText(std::move(bytes), notes);
  }
  CanonicalFile file = preflight(path, std::move(bytes));
  file.report.notes.insert(file.report.notes.begin(), notes.begin(), notes.end());

  const MeshReport& report = file.report;
  if (report.sourceFaces == 0)
    throw Error(path.string(), "has no faces (" + countOf(report.sourceVertices, "vertex", "vertices") + ")",
                "give a mesh with faces");
  const std::string unusable = "none of its " + countOf(report.sourceFaces, "face") +
                               " can be used: " + countOf(report.badIndexFaces, "bad index", "bad indices") +
                               ", " +
                               countOf(report.nonFiniteFaces, "non-finite vertex", "non-finite vertices") +
                               ", " + std::to_string(report.shortFaces) + " under three corners";
  if (file.faces == 0 && report.zeroAreaTriangles == 0)
    throw Error(path.string(), unusable, "export the mesh again");
  LoadedMesh loaded;
  loaded.sources.push_back(path);
  loaded.sources.insert(loaded.sources.end(), file.sources.begin(), file.sources.end());
  if (file.faces > 0) {
    const RawMesh raw = importWithOpenMesh(path.string(), file);
    loaded.mesh =
        makeRenderVertices(raw, file, options.creaseAngleDegrees.value_or(kDefaultCreaseAngleDegrees),
                           options.creaseAngleDegrees.has_value());
  }
  if (loaded.mesh.triangles.empty()) {
    throw Error(path.string(), unusable + ", the rest without area", "export the mesh again");
  }
  return loaded;
}

}  // namespace shprt
