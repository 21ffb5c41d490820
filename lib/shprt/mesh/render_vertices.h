// Polygons to render vertices: triangulation, normals, and one vertex per distinct combination of attributes.
#pragma once

#include "shprt/mesh/raw_mesh.h"

namespace shprt {

// creaseAngleDegrees: edges sharper than this stay hard where normals are computed. recompute: ignore normals
// that the raw mesh has. file gives materials and the counts so far, which the result's report continues.
Mesh makeRenderVertices(const RawMesh& raw, const CanonicalFile& file, double creaseAngleDegrees,
                        bool recompute);

}  // namespace shprt
