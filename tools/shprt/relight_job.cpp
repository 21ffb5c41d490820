#include "relight_job.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "commands.h"
#include "shprt/sh/rotation.h"

namespace shprt {

void checkLighting(const RelightOptions& options, const CLI::App& parsed, bool assetEmits) {
  if (options.emission && !assetEmits)
    throw UsageError("--emission: " + options.asset + " has no emission of its own to scale");
  if (!options.lights.empty()) return;
  if (!assetEmits) throw UsageError("LIGHT is required: " + options.asset + " has no emission of its own");
  for (const char* name : {"--rotate", "--layout", "--window", "--turntable", "--background"}) {
    if (parsed.get_option(name)->count() > 0)
      throw UsageError(std::string(name) + ": applies to LIGHTs, and there are none");
  }
}

LightSum addUpLights(const Console& console, const RelightOptions& options, int assetDegree) {
  LightSum sum;
  if (options.lights.empty()) {
    sum.light.coefficients = {{0, 0, 0}};
    return sum;
  }
  LightOptions lightOptions = options.light;
  lightOptions.degree = assetDegree;
  int lowest = assetDegree;
  for (std::size_t i = 0; i < options.lights.size(); ++i) {
    LoadedLight loaded = loadLight(options.lights[i], lightOptions);
    console.field("light", fmt::format("{}, degree {}", options.lights[i], loaded.light.degree));
    for (const std::string& note : loaded.notes) console.field("", note);
    if (loaded.light.degree != assetDegree) {
      console.note(fmt::format("{} has degree {}, the asset {}: the bands up to {} are used",
                               options.lights[i], loaded.light.degree, assetDegree,
                               std::min(loaded.light.degree, assetDegree)));
    }
    lowest = std::min(lowest, loaded.light.degree);
    sum.light = i == 0 ? std::move(loaded.light) : addLights(sum.light, loaded.light);
    sum.sources.insert(sum.sources.end(), loaded.sources.begin(), loaded.sources.end());
    if (loaded.map) sum.maps.push_back(std::move(*loaded.map));
  }
  // Bands the asset lacks would only be turned in vain.
  if (sum.light.degree > lowest) sum.light = withDegree(sum.light, lowest);
  if (options.window != Window::kNone) {
    WindowResult windowed = applyWindow(sum.light, options.window);
    console.field("window", fmt::format("{}; takes {:.3g}% of the energy in bands 1 and up", windowed.name,
                                        100 * windowed.strength));
    sum.light = std::move(windowed.light);
  }
  if (options.exposure) sum.light = scaleLight(sum.light, std::exp2(*options.exposure));
  return sum;
}

double emissionScale(const RelightOptions& options) {
  return options.emission.value_or(1) * std::exp2(options.exposure.value_or(0));
}

int frameCount(const RelightOptions& options) {
  return options.turntable.value_or(1);
}

std::optional<Mat3> frameRotation(const RelightOptions& options, int frame) {
  const std::optional<Mat3> asked = options.rotation ? std::optional(options.rotation->matrix) : std::nullopt;
  if (!options.turntable) return asked;
  const double degrees = 360.0 * frame / *options.turntable;
  return parseRotation(fmt::format("axis:0,1,0,{}", degrees)) * asked.value_or(Mat3{});
}

LightCoefficients frameLight(const RelightOptions& options, const LightCoefficients& light, int frame) {
  const std::optional<Mat3> rotation = frameRotation(options, frame);
  return rotation ? rotateLight(light, *rotation) : light;
}

std::string frameFile(const RelightOptions& options, int frame) {
  if (!options.turntable) return options.output;
  const std::filesystem::path path(options.output);
  const std::string name =
      fmt::format("{}_{:04d}{}", path.stem().string(), frame + 1, path.extension().string());
  return (path.parent_path() / name).string();
}

}  // namespace shprt
