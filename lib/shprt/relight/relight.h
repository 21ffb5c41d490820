// Outgoing radiance at every vertex: the dot product of its transfer with the light, and what
// the scene's own lights add.
#pragma once

#include <vector>

#include "shprt/base/vec.h"
#include "shprt/coefficients/light_coefficients.h"
#include "shprt/coefficients/transfer_asset.h"

namespace shprt {

// Linear Rec.709 outgoing radiance per vertex. Uses the bands that both have.
std::vector<Vec3f> relight(const TransferCoefficients& transfer, const LightCoefficients& light);

// The same for a whole asset, plus emissionScale (not negative) times the radiance that the scene's own
// lights cause. The light may be black (degree 0, one zero); it alone turns, so emission is the same for
// every light.
std::vector<Vec3f> relight(const TransferAsset& asset, const LightCoefficients& light, double emissionScale);

}  // namespace shprt
