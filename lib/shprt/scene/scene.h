// What is baked: all surfaces of a scene in one frame, and what they are made of.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/image/image.h"
#include "shprt/mesh/mesh.h"

namespace shprt {

inline constexpr float kDefaultAlbedo = 0.8f;

// Effects that are not simulated yet; recorded, so that it can be said what ignoring them leaves out.
struct Gloss {
  Vec3f reflectance;    // of the mirror-like part, linear Rec.709 in [0,1]
  float roughness = 0;  // in [0,1]
};
struct Translucency {
  Vec3f transmittance;     // share of light that enters and leaves elsewhere, linear Rec.709 in [0,1]
  float meanFreePath = 0;  // in scene units
};

struct SurfaceMaterial {
  std::string name;  // "" where the file gives none
  // Where vertices have no colour and no texture says otherwise; linear Rec.709 in [0,1].
  Vec3f albedo{kDefaultAlbedo, kDefaultAlbedo, kDefaultAlbedo};
  std::optional<std::uint32_t> texture;  // index into Scene::textures: gives the albedo
  bool twoSided = false;                 // the mesh holds both sides then, back to back
  Vec3f emission;                        // radiance that the front sends out, linear Rec.709, not negative
  std::optional<Gloss> gloss;
  std::optional<Translucency> translucency;
};

enum class Role {
  kReceiver,  // baked; casts shadows and reflects
  kBlocker    // casts shadows and reflects, but is not part of the asset
};

struct SceneObject {
  std::string name;  // unique in the scene
  std::string file;  // as given
  Role role = Role::kReceiver;
  MeshReport report;
};

// How many vertices have their albedo from where; back sides of two-sided materials do not count.
struct AlbedoSources {
  std::uint64_t asked = 0;      // LoadSceneOptions::albedo, or given to makeScene
  std::uint64_t sceneFile = 0;  // "albedo" of a scene file
  std::uint64_t textures = 0;
  std::uint64_t vertexColours = 0;
  std::uint64_t materials = 0;  // diffuse colours of mesh files' materials
  std::uint64_t defaulted = 0;  // kDefaultAlbedo
};

// The side of a triangle on which its corners' normals are is its front. Fronts reflect and emit; backs are
// black: they only cast shadows.
struct Scene {
  // Of all objects, in scene units; vertexMaterials index `materials`. Without materials and colours of its
  // own; its report is the sum of the files', whose notes are in `notes`.
  Mesh mesh;
  std::vector<Vec3f> albedo;                   // per vertex, linear Rec.709 in [0,1]
  std::vector<std::uint32_t> vertexObjects;    // per vertex, index into objects
  std::vector<SceneObject> objects;            // at least one
  std::vector<SurfaceMaterial> materials;      // at least one
  std::vector<Image> textures;                 // linear albedo in [0,1]
  std::vector<std::filesystem::path> sources;  // every file that was read, the one asked for first
  std::vector<std::string> notes;              // what was assumed or ignored, one line each
  AlbedoSources albedoSources;

  // A triangle's corners share material and object.
  const SurfaceMaterial& materialOf(std::uint32_t triangle) const {
    return materials[mesh.vertexMaterials[mesh.triangles[triangle][0]]];
  }
  bool isReceiver(std::uint32_t vertex) const {
    return objects[vertexObjects[vertex]].role == Role::kReceiver;
  }
  bool emits() const;  // whether any material in use sends out light

  // Albedo inside a triangle, at barycentrics u, v of corners 1 and 2: the texture's where there is one, else
  // interpolated.
  Vec3f albedoAt(std::uint32_t triangle, float u, float v) const;
};

// Gives every albedo, in textures too, the mean of its channels: for scenes whose colours do not matter.
void makeGrey(Scene& scene);

// A scene of one receiver. albedo: one entry per vertex.
Scene makeScene(Mesh mesh, std::vector<Vec3f> albedo);

}  // namespace shprt
