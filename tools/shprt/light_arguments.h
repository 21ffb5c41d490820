// A LIGHT on the command line: a light file, a list of lights, or an image of the surroundings, told apart by
// content.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "console.h"
#include "options.h"
#include "shprt/coefficients/light_coefficients.h"
#include "shprt/image/environment.h"
#include "shprt/light/project_probe.h"

namespace shprt {

// Of lights that formulas give; images stop at kMaximumBakeDegree.
inline constexpr int kMaximumLightDegree = 1000;

struct LightOptions {
  int degree = 4;                                // of lists and images; a light file keeps its own
  std::optional<EnvironmentLayout> layout = {};  // of images; empty means automatic
  bool clampNegative = false;
  bool strict = false;  // refuse bad pixels
};

struct LoadedLight {
  LightCoefficients light;
  std::optional<EnvironmentMap> map;           // images only
  std::optional<ProbeProjection> projection;   // images only; its own light is moved to `light`
  std::vector<std::string> notes;              // layout taken, pixels mended
  std::vector<std::filesystem::path> sources;  // every file that was read
};

// Throws Error. --layout with anything but an image is a UsageError, and so is an image of too high a degree.
LoadedLight loadLight(const std::string& path, const LightOptions& options);

// The lights that a plan is for, looked at to a degree beyond any that is likely to be chosen; notes go to
// the console. Adds every file that was read to sources. Throws as loadLight.
std::vector<LightCoefficients> loadPlanLights(const Console& console, const std::vector<std::string>& paths,
                                              std::optional<EnvironmentLayout> layout,
                                              std::vector<std::filesystem::path>& sources);

// --layout
CLI::Option* addLayout(CLI::App& app, std::optional<EnvironmentLayout>& layout);

}  // namespace shprt
