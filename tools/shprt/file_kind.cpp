#include "file_kind.h"

#include <filesystem>
#include <system_error>

#include "output.h"
#include "shprt/base/error.h"
#include "shprt/base/exr_header.h"
#include "shprt/base/json_input.h"
#include "shprt/coefficients/asset_file.h"

namespace shprt {
namespace {

bool hasMeshSuffix(const std::string& path) {
  const std::string suffix = suffixOf(path);
  return suffix == ".obj" || suffix == ".ply" || suffix == ".off" || suffix == ".stl";
}

// A damaged asset is no longer recognised by its parts, but its name still says what it was meant to be.
bool isNamedAsset(const std::string& path) {
  return path.ends_with(".prt.exr") && isExrFile(path);
}

}  // namespace

void checkInput(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (!fs::exists(status)) {
    if (path.find("%s") != std::string::npos) return;
    throw Error(path, "no such file", "check the path");
  }
  if (!fs::is_regular_file(status) && !fs::is_directory(status)) {
    throw Error(path, "is a pipe or device", "save its content to a file first");
  }
}

FileKind fileKind(const std::string& path) {
  checkInput(path);
  if (isAssetFile(path) || isNamedAsset(path)) return FileKind::kAsset;
  const JsonOutline json = outlineJson(path);
  if (json.object && json.hasObjects) return FileKind::kScene;
  if (json.object) return json.hasLights ? FileKind::kLightList : FileKind::kLight;
  return hasMeshSuffix(path) ? FileKind::kMesh : FileKind::kImage;
}

const char* kindName(FileKind kind) {
  switch (kind) {
    case FileKind::kAsset:
      return "an asset";
    case FileKind::kLight:
      return "a light file";
    case FileKind::kLightList:
      return "a list of lights";
    case FileKind::kScene:
      return "a scene";
    case FileKind::kMesh:
      return "a mesh";
    case FileKind::kImage:
      break;
  }
  return "an image";
}

}  // namespace shprt
