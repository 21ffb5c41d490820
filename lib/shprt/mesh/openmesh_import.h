// The one door to OpenMesh: its parsers, without its half-edge mesh.
#pragma once

#include <string>

#include "shprt/mesh/raw_mesh.h"

namespace shprt {

// Parses a canonical file and checks that everything in it arrived; consumes file.bytes. path is for
// messages. Throws Error when OpenMesh delivers something else than the preflight counted.
RawMesh importWithOpenMesh(const std::string& path, CanonicalFile& file);

}  // namespace shprt
