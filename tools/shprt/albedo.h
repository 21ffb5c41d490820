// Which albedo each vertex is baked with.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shprt/mesh/mesh.h"
#include "shprt/scene/scene.h"

namespace shprt {

struct AlbedoChoice {
  std::vector<Vec3f> perVertex;
  std::string description;  // "0.5 as asked for", "from 3 materials", "0.8 grey, the default: ..."
};

// The one asked for, else each material's diffuse colour, else kDefaultAlbedo grey.
AlbedoChoice chooseAlbedo(const Mesh& mesh, const std::optional<Vec3f>& asked);

}  // namespace shprt
