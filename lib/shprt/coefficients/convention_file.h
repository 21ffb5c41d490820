// A light in the convention of another tool, as a JSON file (docs/file-formats.md): written for that tool's
// importers, and read back.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "shprt/coefficients/light_coefficients.h"
#include "shprt/sh/convention.h"

namespace shprt {

// Whether the file is a JSON object with "format":"shprt-convention"; false for anything else.
bool isConventionFile(const std::filesystem::path& path);

// The text of such a file. The light's degree must be within what the convention holds.
std::string formatConventionFile(const LightCoefficients& light, Convention convention);

// The light in this project's basis, axes included; degree as the file says. Throws Error naming the field
// (format, newer version, unknown convention, degree it cannot have, wrong count, not finite, a matrix with a
// trace).
LightCoefficients readConventionFile(const std::filesystem::path& path);

// Share in [0,1] of a light's energy, sum of squared coefficients, per colour, in bands above degree.
std::array<double, 3> energyShareAbove(const LightCoefficients& light, int degree);

}  // namespace shprt
