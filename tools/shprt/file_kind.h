// What a file is, by its content first and its suffix only where content cannot tell.
#pragma once

#include <string>

namespace shprt {

enum class FileKind { kAsset, kLight, kLightList, kScene, kMesh, kImage };

// Throws Error unless path is a file or a folder: what is tried as one kind and then another cannot be a pipe
// or device. A pattern with %s, for six faces, passes.
void checkInput(const std::string& path);

// Throws Error where checkInput() does. A file that is none of these counts as an image, whose reader says
// what is wrong.
FileKind fileKind(const std::string& path);

// "an asset", "a light file", "a list of lights", "a scene", "a mesh", "an image".
const char* kindName(FileKind kind);

}  // namespace shprt
