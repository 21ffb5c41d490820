// What the surfaces of a scene are made of: materials of mesh files, vertex colours, textures, and what a
// scene file puts over them.
//
// A vertex has its albedo from the first of: an albedo asked for, albedo or texture in the scene file (the
// object's before the material's), the mesh file's texture, its vertex colour, its material, the default.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "shprt/mesh/mesh.h"
#include "shprt/scene/material_overrides.h"
#include "shprt/scene/scene.h"
#include "shprt/scene/texture_set.h"

namespace shprt {

class SurfaceBuilder {
 public:
  // where: the scene file, for messages. byName: what it says about materials by the names of mesh files.
  // albedo, twoSided: of everything.
  SurfaceBuilder(std::string where, const std::map<std::string, MaterialOverrides>& byName,
                 std::optional<Vec3f> albedo, bool twoSided)
      : where_(std::move(where)), byName_(byName), albedo_(albedo), twoSided_(twoSided) {}

  // Adds the mesh's materials to the scene's and its vertices' albedo to the scene's; the mesh's
  // vertexMaterials index the scene's materials then, and its own are empty, as are its colours. file is for
  // notes. Throws Error when a texture of the scene file cannot be read or used; one of a mesh file is noted
  // and does without.
  void add(Mesh& mesh, const MaterialOverrides& object, const std::string& file, Scene& scene);

  // Gives the scene its textures and notes, once all meshes are added. Throws Error when the scene file names
  // a material that no mesh has.
  void finish(Scene& scene);

 private:
  SurfaceMaterial makeMaterial(const Material& material, const MaterialOverrides& overrides);
  std::optional<std::uint32_t> findTexture(const Mesh& mesh, const Material& material,
                                           const MaterialOverrides& overrides);

  std::string where_;
  const std::map<std::string, MaterialOverrides>& byName_;
  std::optional<Vec3f> albedo_;
  bool twoSided_;
  TextureSet textures_;
  std::set<std::string> names_, missingTextures_;
  std::string firstMissing_;  // why
  std::uint64_t emitting_ = 0, withoutCoordinates_ = 0;
};

}  // namespace shprt
