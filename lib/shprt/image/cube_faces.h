// Cubes whose faces are files of their own.
#pragma once

#include <filesystem>
#include <vector>

#include "shprt/image/environment.h"

namespace shprt {

// The six files that belong to a folder, a pattern with %s, or one of the faces; empty when there are none.
std::vector<std::filesystem::path> findFaces(const std::filesystem::path& path);

// Six square pictures of one size as a strip. path is what the user named. Throws Error.
EnvironmentMap loadFaces(const std::filesystem::path& path, const std::vector<std::filesystem::path>& faces);

// A strip of six faces side by side as one of faces below each other.
Image stackFaces(const Image& strip);

}  // namespace shprt
