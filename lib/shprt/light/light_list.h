// LIGHTS.json: a list of analytic and image lights, added up (docs/file-formats.md has its schema).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "shprt/coefficients/light_coefficients.h"

namespace shprt {

// Whether the file is a JSON object with a "lights" array; false for anything else.
bool isLightList(const std::filesystem::path& path);

struct ProjectedList {
  LightCoefficients light;
  std::vector<std::string> notes;  // what was mended in its probes, layouts taken
  std::vector<std::filesystem::path> sources;
};

// Reads, checks (Error names the light's number and the field; unknown fields and types are refused) and
// projects.
ProjectedList projectLightList(const std::filesystem::path& path, int degree, bool strict = false);

}  // namespace shprt
