#include "shprt/scene/load_scene.h"

#include <algorithm>
#include <map>
#include <utility>

#include "shprt/base/error.h"
#include "shprt/base/json_input.h"
#include "shprt/mesh/load_mesh.h"
#include "shprt/scene/back_sides.h"
#include "shprt/scene/merge_meshes.h"
#include "shprt/scene/surfaces.h"

namespace shprt {
namespace {

// Meshes that objects share are read once, and kept for no longer than they are needed.
class MeshCache {
 public:
  MeshCache(const SceneDescription& description, std::optional<double> creaseAngleDegrees)
      : creaseAngleDegrees_(creaseAngleDegrees) {
    for (const ObjectDescription& object : description.objects) ++entries_[keyOf(object)].usesLeft;
  }

  struct Use {
    LoadedMesh mesh;
    bool first = false;  // use of this file
  };
  Use take(const ObjectDescription& object) {
    const Key key = keyOf(object);
    Entry& entry = entries_.at(key);
    const bool first = !entry.loaded;
    if (first) entry.loaded = loadMesh(object.path, {.creaseAngleDegrees = key.second});
    if (--entry.usesLeft > 0) return {*entry.loaded, first};
    return {std::move(*entry.loaded), first};
  }

 private:
  using Key = std::pair<std::filesystem::path, std::optional<double>>;
  struct Entry {
    int usesLeft = 0;
    std::optional<LoadedMesh> loaded;
  };

  Key keyOf(const ObjectDescription& object) const {
    std::error_code ignored;  // what cannot be found is said by whoever opens it
    return {std::filesystem::weakly_canonical(object.path, ignored),
            object.creaseAngleDegrees ? object.creaseAngleDegrees : creaseAngleDegrees_};
  }

  std::optional<double> creaseAngleDegrees_;
  std::map<Key, Entry> entries_;
};

// A mesh file as the scene it is.
SceneDescription describeMeshFile(const std::filesystem::path& path) {
  SceneDescription description;
  ObjectDescription& object = description.objects.emplace_back();
  object.name = path.stem().string();
  object.file = path.string();
  object.path = path;
  return description;
}

MeshCache::Use takeMesh(MeshCache& meshes, const ObjectDescription& object, const std::string& where) {
  if (object.place.empty()) return meshes.take(object);
  std::error_code problem;
  if (!std::filesystem::exists(object.path, problem))
    throw Error(
        where,
        object.place + ".file names " + object.path.string() +
            (problem ? ", which cannot be looked at: " + problem.message() : ", which does not exist"),
        "paths are relative to the scene file's folder");
  try {
    return meshes.take(object);
  } catch (const Error& error) {
    throw Error(where, object.place + ".file is wrong: " + error.what());
  }
}

void placeMesh(Mesh& mesh, const ObjectDescription& object, const std::string& where,
               std::vector<std::string>& notes) {
  const std::uint64_t lost = transformMesh(mesh, object.transform);
  for (const Vec3f& position : mesh.positions)
    if (!isFinite(position))
      throw Error(where, object.place + ".transform moves vertices beyond the range of float",
                  "use smaller numbers");
  if (mesh.triangles.empty())
    throw Error(where, object.place + ".transform leaves no triangle with area",
                "the mesh is too small for its place, or too small at all");
  if (lost)
    notes.push_back(object.place + ": " + std::to_string(lost) +
                    " triangles lost their area by the transform");
}

void addSource(Scene& scene, const std::filesystem::path& path) {
  if (std::find(scene.sources.begin(), scene.sources.end(), path) == scene.sources.end())
    scene.sources.push_back(path);
}

}  // namespace

Scene loadScene(const std::filesystem::path& path, const LoadSceneOptions& options) {
  const std::string where = path.string();
  const SceneDescription description =
      outlineJson(path).object ? readSceneFile(path) : describeMeshFile(path);
  MeshCache meshes(description, options.creaseAngleDegrees);
  SurfaceBuilder surfaces(where, description.materials, options.albedo, options.twoSided);
  Scene scene;
  scene.sources.push_back(path);
  for (const ObjectDescription& object : description.objects) {
    auto [loaded, first] = takeMesh(meshes, object, where);
    for (const std::filesystem::path& source : loaded.sources) addSource(scene, source);
    const std::string prefix = object.place.empty() ? "" : object.file + ": ";
    if (first)
      for (const std::string& note : loaded.mesh.report.notes) scene.notes.push_back(prefix + note);
    placeMesh(loaded.mesh, object, where, scene.notes);
    surfaces.add(loaded.mesh, object.material, object.path.filename().string(), scene);
    scene.vertexObjects.resize(scene.vertexObjects.size() + loaded.mesh.positions.size(),
                               static_cast<std::uint32_t>(scene.objects.size()));
    scene.objects.push_back({object.name, object.file, object.role, loaded.mesh.report});
    appendMesh(scene.mesh, std::move(loaded.mesh));
  }
  surfaces.finish(scene);
  addBackSides(scene);
  return scene;
}

}  // namespace shprt
