#include "relight_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "shprt/base/error.h"
#include "shprt/picture/tone_map.h"
#include "shprt/relight/error_summary.h"
#include "shprt/relight/relight.h"

namespace shprt {
namespace {

// Of sums that cancel to nothing, relative to the mean.
constexpr double kRounding = 1e-6;

}  // namespace

Ringing measureRinging(const std::vector<Vec3f>& radiance) {
  Ringing ringing;
  for (const Vec3f& value : radiance)
    ringing.mean += static_cast<double>(luminance(value)) / static_cast<double>(radiance.size());
  const auto rounding = static_cast<float>(kRounding * std::max(0.0, ringing.mean));
  for (const Vec3f& value : radiance) {
    const float least = std::min({value.x, value.y, value.z});
    ringing.vertices += least < -rounding;
    ringing.deepest = std::min(ringing.deepest, least);
  }
  return ringing;
}

void noteRinging(const Console& console, const RelightOptions& options, const Ringing& ringing,
                 bool display) {
  if (ringing.vertices == 0) return;
  const auto deepest = static_cast<double>(ringing.deepest);
  const std::string depth = ringing.mean > 0
                                ? fmt::format("{:.2g}% of the mean", 100 * deepest / ringing.mean)
                                : fmt::format("{:.3g}, the mean being {:.3g}", deepest, ringing.mean);
  // Shadows can ring where the unshadowed irradiance, which auto looks at, does not.
  const bool softer = options.window == Window::kNone || options.window == Window::kAuto;
  console.note(fmt::format("{} a negative colour, down to {}, from ringing or negative light{}{}",
                           countOf(ringing.vertices, "vertex has", "vertices have"), depth,
                           display ? "; shown as 0" : "",
                           softer && ringing.mean > 0 ? "; --window hann softens the light" : ""));
}

void checkErrorBars(const RelightOptions& options, const TransferAsset& asset) {
  if (options.errorBars && asset.error.empty()) {
    throw Error(options.asset, "has no standard errors for --error-bars", "bake it with --error-part");
  }
}

std::vector<Vec3f> errorBars(const Console& console, const RelightOptions& options,
                             const TransferAsset& asset, const LightCoefficients& light) {
  if (!options.errorBars) return {};
  if (!asset.emission.empty() && asset.emissionError.empty())
    console.note("the asset does not say how uncertain its emission is; it is taken for exact");
  std::vector<Vec3f> standardErrors = relightError(asset, light, emissionScale(options));
  if (!std::all_of(standardErrors.begin(), standardErrors.end(),
                   [](const Vec3f& value) { return isFinite(value); })) {
    throw Error(options.asset, "standard errors under this light are beyond float",
                "use a dimmer light, --emission or --exposure");
  }
  return standardErrors;
}

Json describeErrorBars(const Console& console, const std::vector<Vec3f>& radiance,
                       const std::vector<Vec3f>& standardErrors) {
  if (standardErrors.empty()) return {};
  const ErrorSummary summary = summariseErrors(radiance, standardErrors);
  const bool lit = summary.rmsRadiance > 0;
  const double relativeRms = lit ? summary.rms / summary.rmsRadiance : 0,
               relativeLargest = lit ? summary.largest / summary.rmsRadiance : 0;
  console.field(
      "standard error",
      lit ? fmt::format("{:.3g}% of the RMS radiance; at most {:.3g}%, at vertex {}", 100 * relativeRms,
                        100 * relativeLargest, summary.largestVertex)
          : fmt::format("{:.3g}, at most {:.3g}, where all radiance is 0", summary.rms, summary.largest));
  return {{"rmsRadiance", summary.rmsRadiance},
          {"rms", summary.rms},
          {"largest", summary.largest},
          {"largestVertex", summary.largestVertex},
          {"relativeRms", lit ? Json(relativeRms) : Json()},
          {"relativeLargest", lit ? Json(relativeLargest) : Json()}};
}

}  // namespace shprt
