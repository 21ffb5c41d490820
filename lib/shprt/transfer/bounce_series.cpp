#include "shprt/transfer/bounce_series.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace shprt {
namespace {

// Where an operator may lose nothing at all, no remainder is infinite for it.
constexpr double kMaximumRatio = 1 - 1e-6;

double fade(double before, double after) {
  return after == 0 ? 0 : before == 0 ? kMaximumRatio : after / before;
}

// Blockers count as well: what they hold may reach receivers later.
double larger(const BandNorm& norm) {
  return std::max(norm.receivers, norm.all);
}

}  // namespace

BounceSeries::BounceSeries(int transferBands, std::vector<double> largestRatio)
    : transferBands_(static_cast<std::size_t>(transferBands)), bounds_(std::move(largestRatio)) {
  for (double& bound : bounds_) bound = std::min(bound, kMaximumRatio);
}

void BounceSeries::add(std::vector<BandNorm> norms) {
  assert(norms.size() == bounds_.size());
  norms_.push_back(std::move(norms));
}

double BounceSeries::norm() const {
  double squares = 0;
  for (std::size_t band = 0; band < transferBands_; ++band)
    squares += norms_.back()[band].receivers * norms_.back()[band].receivers;
  return std::sqrt(squares / static_cast<double>(transferBands_));
}

double BounceSeries::ratio(int band) const {
  const auto b = static_cast<std::size_t>(band);
  const std::size_t count = norms_.size();
  double observed = kMaximumRatio;
  if (count >= 2) observed = fade(norms_[count - 2][b].all, norms_[count - 1][b].all);
  if (count >= 3) observed = std::max(observed, fade(norms_[count - 3][b].all, norms_[count - 2][b].all));
  return std::min(observed, bounds_[b]);
}

double BounceSeries::largestRatio() const {
  double largest = 0;
  for (std::size_t band = 0; band < bounds_.size() && bounces() > 0; ++band)
    largest = std::max(largest, ratio(static_cast<int>(band)));
  return largest;
}

double BounceSeries::tail(int band) const {
  const auto b = static_cast<std::size_t>(band);
  const double r = std::sqrt(ratio(band) * bounds_[b]);
  return r / (1 - r) * larger(norms_.back()[b]);
}

double BounceSeries::remainder() const {
  double transfer = 0, emission = 0, brought = 0;
  for (std::size_t band = 0; band < bounds_.size(); ++band) {
    const double left = tail(static_cast<int>(band));
    (band < transferBands_ ? transfer : emission) += left * left;
    if (band < transferBands_) continue;
    double sum = 0, sumOfReceivers = 0;
    for (const std::vector<BandNorm>& norms : norms_) {
      sum += norms[band].all;
      sumOfReceivers += norms[band].receivers;
    }
    const double seen = sumOfReceivers > 0 ? sumOfReceivers : sum;
    brought += seen * seen;
  }
  return std::max(std::sqrt(transfer / static_cast<double>(transferBands_)),
                  brought > 0 ? std::sqrt(emission / brought) : 0.0);
}

}  // namespace shprt
