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

// Standard error of the same: what sampling leaves uncertain (asset.error, asset.emissionError). With s_l the
// standard error of band l, and L_l(w) what the light's band l sends from direction w, the root of the mean
// of (sum_l s_l sqrt(4 pi / (2l+1)) L_l(w))^2 over the cosine-weighted hemisphere around the normal, as if a
// vertex's errors were white noise there; emissions' added in squares. Averaged over all turns of the light
// the variance is right whatever the noise; for one, the RMS over vertices was 0.8 to 1.3 of the true one
// where it was measured, and single vertices 0.4 to 6 (docs/command-reference.md). Uses the bands that both
// have, and the normals, which are of unit length. Empty where the asset has no errors.
std::vector<Vec3f> relightError(const TransferAsset& asset, const LightCoefficients& light,
                                double emissionScale);

}  // namespace shprt
