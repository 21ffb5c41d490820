// What was loaded of a scene, in words.
#pragma once

#include <string>
#include <vector>

#include "console.h"
#include "shprt/scene/load_scene.h"

namespace shprt {

// "0.8 grey, the default: nothing gives one", "from materials; 0.8 grey for 12 vertices without", ...
std::string describeAlbedo(const Scene& scene, const LoadSceneOptions& options);

// What was left out, mended or assumed, one plain sentence each.
std::vector<std::string> describeLoading(const Scene& scene);

// A line per object, then what was left out or assumed, then the albedo.
void printScene(const Console& console, const std::string& path, const Scene& scene,
                const LoadSceneOptions& options);

}  // namespace shprt
