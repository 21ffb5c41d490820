// Wavefront MTL files: diffuse colours, the names of their textures, and emission.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "shprt/mesh/mesh.h"

namespace shprt {

inline constexpr std::uint32_t kNoMaterial = 0xffffffffu;

using MaterialLibrary = std::map<std::string, Material, std::less<>>;

// Adds the file's materials to library; a name defined before keeps its first definition. Kd is taken as
// linear and clamped to [0,1], Ke as linear radiance and clamped to zero, with notes; Ks is ignored, with a
// note. Throws Error when the file cannot be read.
void readMaterialLibrary(const std::filesystem::path& path, MaterialLibrary& library,
                         std::vector<std::string>& notes);

}  // namespace shprt
