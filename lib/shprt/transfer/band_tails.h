// What cutting spherical harmonics off at a degree leaves out, from the energies of the bands.
//
// Transfer T and light L meet band by band: radiance = sum over l of T_l . L_l. Averaged over all rotations
// of the light, the square of T_l . L_l is |T_l|^2 |L_l|^2 / (2l+1), and bands are uncorrelated: so the RMS
// error of a cut needs nothing but the energies.
#pragma once

#include <span>
#include <vector>

#include "shprt/coefficients/light_coefficients.h"

namespace shprt {

// Mean over channels of |L_l|^2, l = 0..degree, of lights that add up; bands that a light does not have are
// 0.
std::vector<double> lightBandEnergy(std::span<const LightCoefficients> lights, int degree);

// For each degree n below the number of bands: the square root of the share of the sum of all energies that
// lies in bands beyond n; 0 for the last. All 0 when there is no energy.
std::vector<double> tailShares(std::span<const double> bandEnergy);

// Energies of the radiance, as above. Both have the same number of bands.
std::vector<double> radianceBandEnergy(std::span<const double> transferEnergy,
                                       std::span<const double> lightEnergy);

}  // namespace shprt
