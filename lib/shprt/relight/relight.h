// Outgoing radiance at every vertex: the dot product of its transfer with the light.
#pragma once

#include <vector>

#include "shprt/base/vec.h"
#include "shprt/coefficients/light_coefficients.h"
#include "shprt/coefficients/transfer_asset.h"

namespace shprt {

// Linear Rec.709 outgoing radiance per vertex. Uses the bands that both have.
std::vector<Vec3f> relight(const TransferCoefficients& transfer, const LightCoefficients& light);

}  // namespace shprt
