// Which triangles lie back to back: how a mesh holds the two sides of one sheet.
#pragma once

#include <cstdint>
#include <vector>

#include "shprt/mesh/mesh.h"

namespace shprt {

inline constexpr std::uint32_t kNoTriangle = ~std::uint32_t{0};

// For each triangle the least index of one with the same three corner positions (bit for bit, -0 equals 0)
// and the opposite winding, or kNoTriangle. Their corners come in different orders: match them by position.
std::vector<std::uint32_t> oppositeTriangles(const Mesh& mesh);

}  // namespace shprt
