#include "shprt/study/bake_settings.h"

#include <fmt/core.h>

#include <cassert>
#include <cmath>

namespace shprt {
namespace {

const char* nameOf(AssetCompression compression) {
  switch (compression) {
    case AssetCompression::kZip:
      return "zip";
    case AssetCompression::kZips:
      return "zips";
    case AssetCompression::kPiz:
      return "piz";
    case AssetCompression::kNone:
      break;
  }
  return "none";
}

}  // namespace

std::string optionsOf(const BakeSettings& settings) {
  const BakeRequest& request = settings.request;
  std::string text = fmt::format("--model {} --degree {}", request.model, request.degree);
  if (request.model != "unshadowed") {
    text += request.samplingError ? fmt::format(" --error {:g}", errorAskedFor(request))
                                  : fmt::format(" --rays {}", request.rays);
    if (request.model == "interreflected" && request.bounces) {
      text += fmt::format(" --bounces {}", *request.bounces);
    } else if (request.model == "interreflected" && !request.samplingError &&
               request.error != BakeRequest{}.error) {
      text += fmt::format(" --error {:g}", request.error);
    }
    if (request.seed != BakeRequest{}.seed) text += fmt::format(" --seed {}", request.seed);
  }
  if (settings.storage.half) text += " --half";
  if (settings.storage.compression != AssetCompression::kNone)
    text += fmt::format(" --compression {}", nameOf(settings.storage.compression));
  return text;
}

std::string bakeCommand(const StudyRun& run, const BakeSettings& settings, const std::string& output) {
  return fmt::format("shprt bake {} -o {} {}", run.arguments, output, optionsOf(settings));
}

}  // namespace shprt
