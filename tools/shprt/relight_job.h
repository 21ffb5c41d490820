// One call of shprt relight: what was asked for, and the lights it adds up.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "console.h"
#include "light_arguments.h"
#include "options.h"
#include "shprt/light/window.h"

namespace shprt {

enum class RelightFormat { kPly, kExr, kPng, kCsv, kJson };

struct RelightOptions {
  std::string asset, output;
  std::vector<std::string> lights;
  std::optional<RelightFormat> textFormat;  // csv or json, overrides the suffix of output
  LightOptions light;
  Window window = Window::kNone;
  std::optional<RotationArgument> rotation;
  std::optional<double> exposure;
  std::optional<double> emission;  // factor on the asset's own emission
  bool errorBars = false;
  std::string camera;  // "" for the automatic one
  int width = 960, height = 720, samples = 16;
  bool background = false;  // show the image that gives the light
  std::optional<Vec3f> backgroundColour;
  std::optional<int> turntable;  // frames; empty for one picture and no turning
  int threads = 0;
  CommonOptions common;
};

// Throws UsageError unless there is light: LIGHTs, or emission of the asset's own, which alone leaves no use
// for options that are about lights.
void checkLighting(const RelightOptions& options, const CLI::App& parsed, bool assetEmits);

// The lights added up and windowed, in their own orientation, times 2^exposure.
struct LightSum {
  LightCoefficients light;
  std::vector<EnvironmentMap> maps;            // of the lights that are images
  std::vector<std::filesystem::path> sources;  // every file that was read
};

// Says per light what was read, and notes where degrees differ: the bands that all have are used. No light at
// all is black, of degree 0.
LightSum addUpLights(const Console& console, const RelightOptions& options, int assetDegree);

// What the asset's emission is multiplied by: --emission times 2^exposure.
double emissionScale(const RelightOptions& options);

// Pictures to make: 1 without --turntable.
int frameCount(const RelightOptions& options);

// The turn of the light in one frame: --rotate first, then the turntable's part of a full circle about +Y.
// Empty when nothing turns.
std::optional<Mat3> frameRotation(const RelightOptions& options, int frame);

// The light as it stands in one frame.
LightCoefficients frameLight(const RelightOptions& options, const LightCoefficients& light, int frame);

// The file of one frame: OUT itself, or OUT with _0001, _0002, ... before its suffix.
std::string frameFile(const RelightOptions& options, int frame);

}  // namespace shprt
