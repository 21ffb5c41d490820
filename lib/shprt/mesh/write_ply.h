// A mesh with a colour per vertex, as binary PLY.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>

#include "shprt/base/vec.h"
#include "shprt/mesh/mesh.h"

namespace shprt {

// Writes positions, normals, per-vertex colours (8-bit sRGB `red green blue`, as every viewer expects, and
// the linear radiance itself as float `radiance_r radiance_g radiance_b`) and triangles. colours8 and
// radiance have one entry per vertex, and so have the standard errors of radiance (`radiance_error_r
// radiance_error_g radiance_error_b`), unless they are left out. Written atomically. Throws Error.
void writePly(const std::filesystem::path& path, std::span<const Vec3f> positions,
              std::span<const Vec3f> normals, std::span<const std::array<std::uint8_t, 3>> colours8,
              std::span<const Vec3f> radiance, std::span<const Triangle> triangles,
              std::span<const Vec3f> standardErrors = {});

}  // namespace shprt
