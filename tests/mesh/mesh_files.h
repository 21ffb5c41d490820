// Mesh files that tests write, and the table of the shared ones.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/mesh/load_mesh.h"
#include "tests/scratch.h"

namespace shprt::test {

inline Mesh loadText(const std::string& name, const std::string& bytes, const LoadMeshOptions& options = {}) {
  return loadMesh(writeScratch(name, bytes), options).mesh;
}

inline std::string errorOf(const std::string& path) {
  try {
    loadMesh(path);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

inline bool hasNote(const Mesh& mesh, const std::string& fragment) {
  for (const std::string& note : mesh.report.notes) {
    if (note.find(fragment) != std::string::npos) return true;
  }
  return false;
}

// A unit cube of six quads over eight vertices, outward.
inline const std::string kCubeObj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

struct ManifestRow {
  std::string file;  // relative to shared/data
  std::uint64_t vertices = 0, faces = 0, triangles = 0;
  bool counted = false;
};

inline std::vector<ManifestRow> readManifest() {
  std::vector<ManifestRow> rows;
  std::ifstream in(SHPRT_SHARED_DIR "/data/MANIFEST.md");
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells;
    for (std::size_t at = 0; at < line.size();) {
      const std::size_t end = std::min(line.find('|', at), line.size());
      std::string cell = line.substr(at, end - at);
      cell.erase(0, cell.find_first_not_of(' '));
      cell.erase(cell.find_last_not_of(' ') + 1);
      cells.push_back(cell);
      at = end + 1;
    }
    if (cells.size() < 6 || (!cells[1].starts_with("meshes/") && !cells[1].starts_with("problem/"))) continue;
    ManifestRow row{cells[1]};
    if (!cells[3].empty() && std::isdigit(static_cast<unsigned char>(cells[3][0])) &&
        cells[3].find('x') == std::string::npos) {
      row.vertices = std::stoull(cells[3]);
      row.faces = std::stoull(cells[4]);
      row.triangles = std::stoull(cells[5]);
      row.counted = true;
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace shprt::test
