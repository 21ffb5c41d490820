#include "shprt/scene/scene_file.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "shprt/base/json_input.h"
#include "shprt/scene/read_transform.h"

namespace shprt {
namespace {

Role readRole(const JsonObject& entry) {
  const std::string role = entry.text("role");
  if (role == "receiver") return Role::kReceiver;
  if (role == "blocker") return Role::kBlocker;
  entry.fail("role", "'" + role.substr(0, 40) + "' is not known", "use receiver or blocker");
}

double readCreaseAngle(const JsonObject& entry) {
  const double degrees = entry.number("creaseAngle");
  if (degrees < 0 || degrees > 180) entry.fail("creaseAngle", "is not in 0 to 180 degrees");
  return degrees;
}

// Assets of single objects are called by it.
std::string readName(const JsonObject& entry) {
  const std::string name = entry.text("name");
  const auto isForbidden = [](unsigned char c) { return c < 0x20 || c == 0x7f || c == '/'; };
  if (name.empty() || name == "." || name == ".." || std::any_of(name.begin(), name.end(), isForbidden))
    entry.fail("name", "cannot be part of a file's name",
               "give one without '/' and control characters, or leave it out");
  return name;
}

ObjectDescription readObject(const JsonObject& entry, const std::filesystem::path& folder) {
  entry.allowOnly({"name", "file", "role", "transform", "material", "creaseAngle"});
  ObjectDescription object;
  object.place = entry.placeOf("");
  object.file = entry.text("file");
  if (object.file.empty()) entry.fail("file", "is empty", "name a mesh file");
  object.path = folder / object.file;
  if (entry.has("name")) object.name = readName(entry);
  if (entry.has("role")) object.role = readRole(entry);
  if (entry.has("transform")) object.transform = readTransform(entry, "transform");
  if (entry.has("material")) object.material = readMaterialOverrides(entry.object("material"), folder);
  if (entry.has("creaseAngle")) object.creaseAngleDegrees = readCreaseAngle(entry);
  return object;
}

// Objects without a name are called by their files: "box", "box-2".
void giveNames(std::vector<ObjectDescription>& objects, const JsonObject& file) {
  std::set<std::string> taken;
  for (const ObjectDescription& object : objects) {
    if (!object.name.empty() && !taken.insert(object.name).second)
      file.fail(object.place + ".name", "'" + object.name.substr(0, 40) + "' is given to another object too",
                "give each object a name of its own");
  }
  std::map<std::string, int> numbers;  // the last one tried, by stem
  for (ObjectDescription& object : objects) {
    if (!object.name.empty()) continue;
    const std::string stem = object.path.stem().string();
    object.name = stem;
    int& number = numbers.try_emplace(stem, 1).first->second;
    while (!taken.insert(object.name).second) object.name = stem + "-" + std::to_string(++number);
  }
}

}  // namespace

bool isSceneFile(const std::filesystem::path& path) {
  return outlineJson(path).hasObjects;
}

SceneDescription readSceneFile(const std::filesystem::path& path) {
  const nlohmann::json content = readJsonObject(path);
  const JsonObject file(path.string(), "", content);
  file.allowOnly({"$schema", "objects", "materials"});
  if (file.has("$schema")) file.text("$schema");
  const nlohmann::json& objects = file.list("objects");
  if (objects.empty()) file.fail("objects", "is empty", "write [{\"file\": \"mesh.obj\"}, ...]");
  SceneDescription scene;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const JsonObject entry(path.string(), "objects[" + std::to_string(i) + "]", objects[i]);
    scene.objects.push_back(readObject(entry, path.parent_path()));
  }
  if (std::none_of(scene.objects.begin(), scene.objects.end(),
                   [](const ObjectDescription& object) { return object.role == Role::kReceiver; }))
    file.fail("objects", "are all blockers, so that nothing is baked", "make one of them a receiver");
  giveNames(scene.objects, file);
  if (file.has("materials")) {
    const JsonObject materials = file.object("materials");
    for (const std::string& name : materials.names()) {
      const JsonObject material(path.string(), "materials." + name, materials.field(name));
      scene.materials[name] = readMaterialOverrides(material, path.parent_path());
    }
  }
  return scene;
}

}  // namespace shprt
