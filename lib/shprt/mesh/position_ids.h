// Which vertices sit at the same place: one number per distinct position.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

// Numbers the distinct positions in order of first use; positions are the same when all their bits are (-0
// equals 0).
std::vector<std::uint32_t> distinctPositionIds(std::span<const Vec3f> positions);

// The same for pairs of position and normal: the points that are baked, which seams in texture or material
// share.
std::vector<std::uint32_t> distinctPointIds(std::span<const Vec3f> positions, std::span<const Vec3f> normals);

}  // namespace shprt
