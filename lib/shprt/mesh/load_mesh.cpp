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

namespace shprt {
namespace {

using Preflight = CanonicalFile (*)(const std::filesystem::path&, std::string);

// UTF-16 to UTF-8, as far as mesh files need it: pairs of surrogates become question marks, only comments
// have them.
std::string fromUtf16(std::string_view bytes, bool bigEndian) {
  std::string text;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto first = static_cast<unsigned char>(bytes[i]),
               second = static_cast<unsigned char>(bytes[i + 1]);
    const unsigned unit = bigEndian ? first * 256u + second : second * 256u + first;
    if (unit < 0x80) {
      text += static_cast<char>(unit);
    } else if (unit < 0x800) {
      text += static_cast<char>(0xc0 | unit >> 6);
      text += static_cast<char>(0x80 | (unit & 63));
    } else {
      text += '?';
    }
  }
  return text;
}

// Byte-order marks, and UTF-16 with or without one, give way to plain bytes.
std::string decodeText(std::string bytes, std::vector<std::string>& notes) {
  if (bytes.starts_with("\xef\xbb\xbf")) return bytes.substr(3);
  const std::string_view view = bytes;
  const bool marked = view.starts_with("\xff\xfe") || view.starts_with("\xfe\xff");
  const bool looksBig = view.size() >= 4 && view[0] == 0 && view[1] != 0 && view[2] == 0 && view[3] != 0;
  const bool looksLittle = view.size() >= 4 && view[0] != 0 && view[1] == 0 && view[2] != 0 && view[3] == 0;
  if (!marked && !looksBig && !looksLittle) return bytes;
  notes.push_back("UTF-16 text converted");
  return fromUtf16(view.substr(marked ? 2 : 0), marked ? view[0] == '\xfe' : looksBig);
}

Preflight choosePreflight(const std::filesystem::path& path, std::string_view bytes) {
  std::string suffix = path.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
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
  if (preflight == preflightObj || preflight == preflightOff) bytes = decodeText(std::move(bytes), notes);
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
