// Scene files: JSON to plain descriptions, checked field by field; no mesh or picture is opened yet.
// The format is in docs/scenes.md and docs/scene.schema.json.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "shprt/scene/material_overrides.h"
#include "shprt/scene/scene.h"
#include "shprt/scene/transform.h"

namespace shprt {

struct ObjectDescription {
  std::string place;           // in the scene file, for messages: "objects[2]"
  std::string name;            // unique
  std::string file;            // as the scene file gives it
  std::filesystem::path path;  // the same, found from the scene file's folder
  Role role = Role::kReceiver;
  Transform transform;
  MaterialOverrides material;
  std::optional<double> creaseAngleDegrees;
};

struct SceneDescription {
  std::vector<ObjectDescription> objects;              // one receiver at least
  std::map<std::string, MaterialOverrides> materials;  // by the names that mesh files use
};

// Whether a file is a JSON object with a field "objects".
bool isSceneFile(const std::filesystem::path& path);

// Throws Error that names the file and the field at fault ("objects[2].transform.scale").
SceneDescription readSceneFile(const std::filesystem::path& path);

}  // namespace shprt
