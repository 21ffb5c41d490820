// Which vertices have anything above their tangent plane: those, and no others, can be shadowed or lit by
// another surface. Decided without sampling: by what touches them (local_horizon.h) and by bounds on all else
// (scene/occluder_bounds.h, which says what that guarantees). A bake traces no ray from the others, and gives
// them the analytic transfer.
#pragma once

#include <cstdint>
#include <vector>

#include "shprt/transfer/prepared_scene.h"

namespace shprt {

struct VerticesBelow {
  std::vector<std::uint32_t> vertices;  // receivers, increasing
  std::uint64_t points = 0;             // distinct points among them
  std::uint64_t receivers = 0;          // vertices of receivers in all
};

VerticesBelow findVerticesBelow(const PreparedScene& prepared);

}  // namespace shprt
