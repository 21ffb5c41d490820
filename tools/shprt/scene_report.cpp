#include "scene_report.h"

#include <fmt/core.h>

#include <cstdint>
#include <utility>

#include "mesh_report.h"

namespace shprt {

std::string describeAlbedo(const Scene& scene, const LoadSceneOptions& options) {
  if (const auto& asked = options.albedo)
    return fmt::format("{:g} {:g} {:g}, as asked for", asked->x, asked->y, asked->z);
  const AlbedoSources& sources = scene.albedoSources;
  std::string text;
  for (const auto& [count, name] :
       {std::pair(sources.sceneFile, "the scene file"), std::pair(sources.textures, "textures"),
        std::pair(sources.vertexColours, "vertex colours"), std::pair(sources.materials, "materials")}) {
    if (count > 0) text += std::string(text.empty() ? "from " : ", ") + name;
  }
  const std::string grey = fmt::format("{:g} grey", kDefaultAlbedo);
  if (text.empty()) return grey + ", the default: nothing gives one";
  if (sources.defaulted > 0) {
    text += "; " + grey + " for " + countOf(sources.defaulted, "vertex", "vertices") + " without";
  }
  return text;
}

std::vector<std::string> describeLoading(const Scene& scene) {
  // Of a scene, `notes` has what the report of its meshes has, and more.
  MeshReport counts = scene.mesh.report;
  counts.notes.clear();
  std::vector<std::string> lines = describeMending(counts);
  lines.insert(lines.end(), scene.notes.begin(), scene.notes.end());
  return lines;
}

void printScene(const Console& console, const std::string& path, const Scene& scene,
                const LoadSceneOptions& options) {
  if (isSceneFile(path)) {
    console.field("scene", path + ": " + countOf(scene.objects.size(), "object", "objects"));
    for (const SceneObject& object : scene.objects) {
      console.field("", object.name + ": " + object.report.format + ", " +
                            countOf(object.report.sourceVertices, "vertex", "vertices") + ", " +
                            countOf(object.report.sourceFaces, "face", "faces") +
                            (object.role == Role::kBlocker ? ", not baked itself" : ""));
    }
    for (const std::string& line : describeLoading(scene)) console.field("", line);
  } else {
    MeshReport report = scene.mesh.report;
    report.notes = scene.notes;
    printMesh(console, "mesh", path, report);
  }
  console.field("albedo", describeAlbedo(scene, options));
}

}  // namespace shprt
