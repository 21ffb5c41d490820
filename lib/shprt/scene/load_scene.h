// Scene files and mesh files to scenes: the front of the scene room.
#pragma once

#include <filesystem>
#include <optional>

#include "shprt/base/vec.h"
#include "shprt/scene/scene.h"
#include "shprt/scene/scene_file.h"

namespace shprt {

struct LoadSceneOptions {
  std::optional<double> creaseAngleDegrees = {};  // as in LoadMeshOptions; an object's own goes before it
  std::optional<Vec3f> albedo =
      {};                 // of everything, instead of materials, vertex colours and textures; in [0,1]
  bool twoSided = false;  // everything, whatever the materials say
};

// Reads a scene file (JSON, see docs/scenes.md) or a mesh file, which is a scene of one receiver. Two-sided
// materials have both sides in the mesh. Throws Error: what is wrong in a scene file is named by its field,
// as "objects[2].transform.scale".
Scene loadScene(const std::filesystem::path& path, const LoadSceneOptions& options = {});

}  // namespace shprt
