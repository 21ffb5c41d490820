// What a scene file says about materials, over what mesh files say.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "shprt/base/vec.h"
#include "shprt/image/colour_space.h"
#include "shprt/scene/scene.h"

namespace shprt {

class JsonObject;

enum class VertexColourUse { kSrgb, kLinear, kIgnore };

struct TextureReference {
  std::filesystem::path path;
  std::string place;  // in the scene file, for messages: "objects[2].material.texture"
};

struct MaterialOverrides {
  std::optional<Vec3f> albedo;                    // in [0,1]; without a texture
  std::optional<TextureReference> texture;        // without an albedo
  std::optional<ColourSpace> textureColourSpace;  // of this texture, or of the mesh file's
  std::optional<VertexColourUse> vertexColours;
  std::optional<bool> twoSided;
  std::optional<Vec3f> emission;
  std::optional<Gloss> gloss;
  std::optional<Translucency> translucency;

  // These, and where they say nothing, what `general` says. An albedo replaces a texture, and the reverse.
  MaterialOverrides over(const MaterialOverrides& general) const;
};

// folder: of the scene file. Throws Error that names the field at fault.
MaterialOverrides readMaterialOverrides(const JsonObject& entry, const std::filesystem::path& folder);

}  // namespace shprt
