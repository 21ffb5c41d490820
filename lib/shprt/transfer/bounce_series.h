// What is left of light after some bounces, from how fast it fades.
//
// Bounces are powers of one operator, so the ratio of their norms approaches its spectral radius, from below
// where it is symmetric. Two numbers enclose that radius: the ratio observed (the larger of the last two),
// and what no point can exceed, the largest albedo times the largest share of rays that meet fronts. The rest
// is summed with the first. It is bounded with their geometric mean: the second alone, which one dark corner
// can set, would ask for several times the bounces, and the first alone falls short while it still rises, as
// it does where light lingers in cavities. (That is no theorem: a cavity so small that the norms hardly know
// of it can hold more.)
#pragma once

#include <vector>

#include "shprt/transfer/light_norms.h"

namespace shprt {

class BounceSeries {
 public:
  // The first `transferBands` bands are channels of transfer, with norms over that of the unshadowed
  // transfer; others are light of the scene's own. largestRatio: per band, the bound on the operator.
  BounceSeries(int transferBands, std::vector<double> largestRatio);

  // In order, before the first bounce and after each.
  void add(std::vector<BandNorm> norms);

  int bounces() const { return static_cast<int>(norms_.size()) - 1; }
  // What the last bounce added: RMS over channels of receivers' transfer.
  double norm() const;
  // Ratio of a band; until there are bounces, its bound.
  double ratio(int band) const;
  double largestRatio() const;  // over bands; 0 without bounces
  // What all further bounces may add: norm * r / (1 - r) with r between ratio and bound, as said above. The
  // RMS over channels of transfer, or, if larger, that of the scene's own lights over all they have brought
  // so far.
  double remainder() const;

 private:
  double tail(int band) const;

  std::size_t transferBands_;
  std::vector<double> bounds_;
  std::vector<std::vector<BandNorm>> norms_;  // per bounce, per band
};

}  // namespace shprt
