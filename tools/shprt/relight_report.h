// What relight has to say of the radiance it found: where it is negative, and how uncertain it is.
#pragma once

#include <cstdint>
#include <vector>

#include "console.h"
#include "output.h"
#include "relight_job.h"
#include "shprt/coefficients/transfer_asset.h"

namespace shprt {

struct Ringing {
  std::uint64_t vertices = 0;  // with a negative colour
  float deepest = 0;           // most negative value
  double mean = 0;             // luminance
};

Ringing measureRinging(const std::vector<Vec3f>& radiance);

// display: negative values are shown as 0.
void noteRinging(const Console& console, const RelightOptions& options, const Ringing& ringing, bool display);

// Standard errors of the radiance under the light; empty without --error-bars. Throws Error when they are
// beyond float.
std::vector<Vec3f> errorBars(const Console& console, const RelightOptions& options,
                             const TransferAsset& asset, const LightCoefficients& light);

// Throws Error when --error-bars asks for what the asset does not have.
void checkErrorBars(const RelightOptions& options, const TransferAsset& asset);

// Prints their figures and returns the same; null without any.
Json describeErrorBars(const Console& console, const std::vector<Vec3f>& radiance,
                       const std::vector<Vec3f>& standardErrors);

}  // namespace shprt
