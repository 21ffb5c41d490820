#include "shprt/transfer/band_tails.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "shprt/sh/basis.h"

namespace shprt {

std::vector<double> lightBandEnergy(std::span<const LightCoefficients> lights, int degree) {
  std::vector<std::array<double, 3>> sum(static_cast<std::size_t>(coefficientCount(degree)));
  for (const LightCoefficients& light : lights) {
    const std::size_t count = std::min(sum.size(), light.coefficients.size());
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t channel = 0; channel < 3; ++channel) sum[i][channel] += light.coefficients[i][channel];
  }
  std::vector<double> energy(static_cast<std::size_t>(degree) + 1);
  for (int l = 0; l <= degree; ++l)
    for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i)
      for (const double c : sum[static_cast<std::size_t>(i)])
        energy[static_cast<std::size_t>(l)] += c * c / 3;
  return energy;
}

std::vector<double> tailShares(std::span<const double> bandEnergy) {
  std::vector<double> shares(bandEnergy.size());
  double beyond = 0, all = 0;
  for (const double energy : bandEnergy) all += energy;
  for (std::size_t l = bandEnergy.size(); l-- > 0; beyond += bandEnergy[l])
    shares[l] = all > 0 ? std::sqrt(std::min(beyond / all, 1.0)) : 0;
  return shares;
}

std::vector<double> radianceBandEnergy(std::span<const double> transferEnergy,
                                       std::span<const double> lightEnergy) {
  assert(transferEnergy.size() == lightEnergy.size());
  std::vector<double> energy(transferEnergy.size());
  for (std::size_t l = 0; l < energy.size(); ++l)
    energy[l] = transferEnergy[l] * lightEnergy[l] / (2 * static_cast<double>(l) + 1);
  return energy;
}

}  // namespace shprt
