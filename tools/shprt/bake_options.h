// What shprt bake is asked for.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "options.h"
#include "shprt/coefficients/asset_file.h"
#include "shprt/scene/load_scene.h"

namespace shprt {

// Which effects are simulated: those the plan finds needed, or those named.
struct EffectChoice {
  bool automatic = true;
  bool shadows = false, interreflection = false;
  // Trace every ray, also those that cannot meet anything: what `automatic` is compared with.
  bool traceEverything = false;
};

// The longest edge that is left as it is, in scene units, or what the transfer itself calls for.
struct EdgeLimit {
  std::optional<double> length;  // empty: auto
};

struct BakeOptions {
  std::string scene, output;
  LoadSceneOptions loading;
  EffectChoice effects;
  std::vector<std::string> lights;  // that the degree is chosen for
  std::optional<int> degree = 4;    // empty: the least that the lights call for
  // What decides on the rays: a number, or the error or the time asked for.
  int rays = 256;
  bool areRaysGiven = false;
  std::optional<double> seconds;  // for the whole command
  std::optional<double> wantedError;
  bool errorPart = false;
  std::uint64_t seed = 1;
  std::optional<int> bounces;  // empty: as many as `error` calls for
  bool choosesRays() const { return !areRaysGiven && (wantedError || seconds); }
  std::optional<EdgeLimit> maxEdge;
  bool fit = false, perMesh = false;
  std::uint64_t hitMemory = std::uint64_t{2} << 30;
  WriteAssetOptions writing;
  int threads = 0;
  CommonOptions common;
};

// Throws UsageError for options that contradict each other; after parsing.
void checkBakeOptions(const BakeOptions& options, const CLI::App& parsed);

void addBakeOptions(CLI::App& sub, BakeOptions& options);

}  // namespace shprt
