// What the mesh loader found, left out and mended.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "console.h"
#include "shprt/mesh/mesh.h"

namespace shprt {

// One plain sentence per kind of thing that was left out or made, nothing for what did not happen.
std::vector<std::string> describeMending(const MeshReport& report);

// "OBJ, 35,947 vertices, 69,451 faces", then what was left out, one line each.
void printMesh(const Console& console, const std::string& label, const std::string& path,
               const MeshReport& report);

// All counts by name, as assets store them.
std::map<std::string, std::uint64_t> meshCounts(const Mesh& mesh);

}  // namespace shprt
