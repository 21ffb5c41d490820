// Mesh coordinates to coordinates that ray tracing in float likes: near the origin and of order one.
//
// Both steps are exact. The scale is a power of two. An axis is shifted only when the mesh lies far from zero
// along it, and then by a float of the mesh's own magnitude, so each difference is a float again (Sterbenz).
// Geometry therefore stays what the file says, bit for bit, at any size and any distance from the origin.
#pragma once

#include <span>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

struct SceneFrame {
  Vec3d offset;      // subtracted first, in file units
  double scale = 1;  // a power of two, applied after

  Vec3f toScene(Vec3f position) const { return toFloat((toDouble(position) - offset) * scale); }
};

// The frame in which the positions (all finite, at least one) have a largest extent between 1 and 2.
SceneFrame chooseSceneFrame(std::span<const Vec3f> positions);

// All positions in that frame.
std::vector<Vec3f> toScene(const SceneFrame& frame, std::span<const Vec3f> positions);

}  // namespace shprt
