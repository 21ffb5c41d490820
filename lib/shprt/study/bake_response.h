// What a bake answers to a light, as one row of numbers per study: errors are distances between answers.
#pragma once

#include <vector>

#include "shprt/coefficients/light_coefficients.h"
#include "shprt/coefficients/transfer_asset.h"

namespace shprt {

// With a light, the radiance of every vertex (r, g, b) by bands up to `degree`, that of the scene's own
// lights included; without one (nullptr), the transfer's own coefficients up to `degree`, which the asset
// has.
std::vector<float> responseOf(const TransferAsset& asset, const LightCoefficients* light, int degree);

// Root of the sum of squares; of the difference. Responses of the same asset's vertices and degree.
double normOf(const std::vector<float>& response);
double distanceOf(const std::vector<float>& a, const std::vector<float>& b);

}  // namespace shprt
