// What can be said about a picture's file before OpenImageIO sees it.
#pragma once

#include <filesystem>

namespace shprt {

// Throws Error for what is no picture or known to be damaged: missing, a directory, empty, a git-LFS pointer,
// a PNG file whose chunks are cut or changed, an OpenEXR file whose headers claim more than it holds.
void checkImageFile(const std::filesystem::path& path);

}  // namespace shprt
