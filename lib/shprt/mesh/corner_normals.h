// Normals from geometry: angle-weighted over the smooth part of the fan around each corner.
// Based on: Thürmer and Wüthrich 1998 (weights by corner angle, independent of the tessellation).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/mesh/mesh.h"

namespace shprt {

// One unit normal per corner of the triangles, which name welded positions and have area. Two triangles are
// smooth across an edge when they alone share it, run along it in opposite directions, and their planes meet
// at no more than the crease angle. So borders of flipped, duplicate or third faces are hard, and each side
// of a two-sided sheet gets its own normal.
std::vector<Vec3f> computeCornerNormals(std::span<const Vec3f> positions, std::span<const Triangle> triangles,
                                        double creaseAngleDegrees);

}  // namespace shprt
