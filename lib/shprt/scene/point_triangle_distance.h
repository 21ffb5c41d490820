// Distance from a point to a triangle.
// Based on: Ericson 2005, "Real-Time Collision Detection", section 5.1.5 (regions of the closest point).
#pragma once

#include "shprt/base/vec.h"

namespace shprt {

// Degenerate triangles count as their edges.
double pointTriangleDistance(Vec3d point, Vec3d a, Vec3d b, Vec3d c);

}  // namespace shprt
