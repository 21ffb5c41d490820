#include "shprt/scene/surfaces.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "shprt/base/error.h"
#include "shprt/scene/texture.h"

namespace shprt {
namespace {

std::string countOf(std::uint64_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

VertexColourUse chooseUse(const Mesh& mesh, const MaterialOverrides& overrides) {
  if (mesh.colours.empty()) return VertexColourUse::kIgnore;
  return overrides.vertexColours.value_or(mesh.coloursAreIntegers ? VertexColourUse::kSrgb
                                                                  : VertexColourUse::kLinear);
}

template <typename T>
void addOnce(std::vector<T>& list, const T& entry) {
  if (std::find(list.begin(), list.end(), entry) == list.end()) list.push_back(entry);
}

// Where the picture is that an MTL file names. Exporters like to write paths of their own machine; the
// picture then lies beside the MTL file more often than not.
std::filesystem::path locateTexture(const Material& material) {
  std::string name = material.diffuseTexture;
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::filesystem::path folder = material.folder, path = folder / name,
                              beside = folder / path.filename();
  std::error_code ignored;
  return !std::filesystem::exists(path, ignored) && std::filesystem::exists(beside, ignored) ? beside : path;
}

}  // namespace

SurfaceMaterial SurfaceBuilder::makeMaterial(const Material& material, const MaterialOverrides& overrides) {
  SurfaceMaterial surface;
  surface.name = material.name;
  if (material.hasDiffuse) surface.albedo = material.diffuse;
  surface.albedo = albedo_.value_or(overrides.albedo.value_or(surface.albedo));
  surface.twoSided = twoSided_ || overrides.twoSided.value_or(false);
  surface.emission = overrides.emission.value_or(material.emission);
  emitting_ += !overrides.emission && material.emission != Vec3f{};
  surface.gloss = overrides.gloss;
  surface.translucency = overrides.translucency;
  return surface;
}

std::optional<std::uint32_t> SurfaceBuilder::findTexture(const Mesh& mesh, const Material& material,
                                                         const MaterialOverrides& overrides) {
  if (overrides.texture) {
    const auto& [path, place] = *overrides.texture;
    if (mesh.textureCoordinates.empty())
      throw Error(where_, place + " is given, but the mesh has no texture coordinates", "leave it out");
    try {
      return textures_.load(path, overrides.textureColourSpace);
    } catch (const Error& error) {
      throw Error(where_, place + " is wrong: " + error.what());
    }
  }
  if (material.diffuseTexture.empty()) return {};
  if (mesh.textureCoordinates.empty()) {
    ++withoutCoordinates_;
    return {};
  }
  const std::filesystem::path path = locateTexture(material);
  if (missingTextures_.contains(path.string())) return {};
  try {
    return textures_.load(path, overrides.textureColourSpace);
  } catch (const Error& error) {
    if (missingTextures_.empty()) firstMissing_ = error.what();
    missingTextures_.insert(path.string());
    return {};
  }
}

void SurfaceBuilder::add(Mesh& mesh, const MaterialOverrides& object, const std::string& file, Scene& scene) {
  struct Source {
    bool fromSceneFile = false, hasDiffuse = false;
    VertexColourUse colours = VertexColourUse::kIgnore;
  };
  std::vector<Source> sources;
  const auto firstMaterial = static_cast<std::uint32_t>(scene.materials.size());
  for (const Material& material : mesh.materials) {
    names_.insert(material.name);
    const auto named = byName_.find(material.name);
    const MaterialOverrides overrides = named == byName_.end() ? object : object.over(named->second);
    scene.materials.push_back(makeMaterial(material, overrides));
    sources.push_back({overrides.albedo.has_value(), material.hasDiffuse, chooseUse(mesh, overrides)});
    if (!albedo_ && !overrides.albedo)
      scene.materials.back().texture = findTexture(mesh, material, overrides);
  }

  AlbedoSources& counts = scene.albedoSources;
  bool srgb = false, linear = false;
  scene.albedo.reserve(scene.albedo.size() + mesh.positions.size());
  for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    const Source& source = sources[mesh.vertexMaterials[vertex]];
    mesh.vertexMaterials[vertex] += firstMaterial;
    const SurfaceMaterial& material = scene.materials[mesh.vertexMaterials[vertex]];
    Vec3f albedo = material.albedo;
    if (albedo_) {
      ++counts.asked;
    } else if (source.fromSceneFile) {
      ++counts.sceneFile;
    } else if (material.texture) {
      albedo = sampleTexture(textures_.images()[*material.texture], mesh.textureCoordinates[vertex]);
      ++counts.textures;
    } else if (source.colours != VertexColourUse::kIgnore && mesh.colours[vertex] != kNoColour) {
      const bool encoded = source.colours == VertexColourUse::kSrgb;
      albedo = encoded ? decodeSrgb(mesh.colours[vertex]) : mesh.colours[vertex];
      (encoded ? srgb : linear) = true;
      ++counts.vertexColours;
    } else {
      ++(source.hasDiffuse ? counts.materials : counts.defaulted);
    }
    scene.albedo.push_back(albedo);
  }
  for (const auto& [used, name] : {std::pair(srgb, "sRGB"), std::pair(linear, "linear")})
    if (used) addOnce(scene.notes, file + ": vertex colours taken as " + name);
  mesh.materials.clear();
  mesh.colours = {};
}

void SurfaceBuilder::finish(Scene& scene) {
  for (const auto& [name, overrides] : byName_) {
    if (names_.contains(name)) continue;
    std::string known;
    for (const std::string& other : names_) known += (known.empty() ? "'" : ", '") + other + "'";
    constexpr std::size_t kShown = 200;
    if (known.size() > kShown) known = known.substr(0, kShown) + "...";
    throw Error(where_, "materials." + name.substr(0, 40) + " is the name of no mesh's material",
                "the meshes have " + known);
  }
  scene.textures = std::move(textures_.images());
  for (const std::filesystem::path& source : textures_.sources()) addOnce(scene.sources, source);
  std::vector<std::string>& notes = scene.notes;
  notes.insert(notes.end(), textures_.notes().begin(), textures_.notes().end());
  if (!missingTextures_.empty())
    notes.push_back(countOf(missingTextures_.size(), "texture") +
                    " of materials cannot be read, done without (" + firstMissing_ + ")");
  if (withoutCoordinates_)
    notes.push_back("textures of " + countOf(withoutCoordinates_, "material") +
                    " ignored: the mesh has no texture coordinates");
  if (emitting_) notes.push_back(countOf(emitting_, "material") + " of mesh files with emission (Ke)");
  const auto count = [&](const auto& has) {
    return static_cast<std::uint64_t>(std::count_if(scene.materials.begin(), scene.materials.end(), has));
  };
  if (const std::uint64_t glossy = count([](const SurfaceMaterial& m) { return m.gloss.has_value(); }))
    notes.push_back("glossy reflection of " + countOf(glossy, "material") + " recorded, not simulated");
  if (const std::uint64_t clear = count([](const SurfaceMaterial& m) { return m.translucency.has_value(); }))
    notes.push_back("translucency of " + countOf(clear, "material") + " recorded, not simulated");
}

}  // namespace shprt
