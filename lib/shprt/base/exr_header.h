// A look at an OpenEXR file that nobody vouches for. OpenEXR takes memory for whatever size an attribute
// claims (a string of 2 GB in a file of 2 kB), so the headers are walked once before OpenEXR sees them.
#pragma once

#include <filesystem>

namespace shprt {

// Whether a file begins with OpenEXR's magic number.
bool isExrFile(const std::filesystem::path& path);

// Whether every attribute of every header of an OpenEXR file lies inside the file.
bool hasWholeExrHeader(const std::filesystem::path& path);

}  // namespace shprt
