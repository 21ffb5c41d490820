// Meshes put one after the other.
#pragma once

#include "shprt/mesh/mesh.h"

namespace shprt {

// Appends a mesh's vertices and triangles to another's, and adds up their reports. vertexMaterials index the
// same list in both; neither has materials or colours of its own. Where only one has texture coordinates, the
// other's are zero. Throws Error when there are more vertices or triangle corners than 32 bits can number.
void appendMesh(Mesh& whole, Mesh part);

}  // namespace shprt
