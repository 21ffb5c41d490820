// What a baked transfer amounts to, in figures that a reader can judge it by.
#pragma once

#include <vector>

#include "shprt/coefficients/transfer_asset.h"

namespace shprt {

struct AssetStatistics {
  float minimum = 0, maximum = 0;  // of all transfer coefficients
  // Mean over vertices and channels of the sum over m of transfer^2, for each band.
  std::vector<double> bandEnergy;
  // Cosine-weighted share of the sky that vertices see, mean and extremes over those that reflect anything;
  // all 0 when none does. Interreflected light counts as sky seen, so it may exceed 1 there.
  double meanVisibility = 0, minimumVisibility = 0, maximumVisibility = 0;
  // Of the radiance that the scene's own lights cause, over vertices and colours; all 0 without any.
  float minimumEmission = 0, maximumEmission = 0;
  double emissionShare = 0;  // of the vertices: those with any colour above 0
  // Standard errors that sampling leaves: of the transfer, RMS over vertices and channels of the 2-norm, over
  // that of the unshadowed transfer; of the scene's own light, RMS over RMS. Negative where the asset has
  // none, and where it would be relative to nothing.
  double transferError = -1, emissionError = -1;
};

AssetStatistics measureAsset(const TransferAsset& asset);

}  // namespace shprt
