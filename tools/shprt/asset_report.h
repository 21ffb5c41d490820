// What an asset says about itself, for people and for machines.
#pragma once

#include <string>

#include "console.h"
#include "output.h"

namespace shprt {

// Prints it and returns the same as figures. Throws Error when the file cannot be read.
Json describeAsset(const Console& console, const std::string& path);

}  // namespace shprt
