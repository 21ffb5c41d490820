#include "shprt/study/settings_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "shprt/sh/basis.h"

namespace shprt {
namespace {

// Errors of nothing at all, so that they have a logarithm.
constexpr double kLeastError = 1e-12;

double atShare(double a, double b, double share) {
  return std::exp(std::lerp(std::log(std::max(a, kLeastError)), std::log(std::max(b, kLeastError)), share));
}

// The setting that just reaches `error`, straight between neighbours in log-log; nothing beyond the last.
std::optional<RayCost> raysFor(const std::vector<RayCost>& rays, double error) {
  const auto next =
      std::find_if(rays.begin(), rays.end(), [&](const RayCost& cost) { return cost.error <= error; });
  if (next == rays.end()) return {};
  if (next == rays.begin()) return *next;
  const RayCost& before = *std::prev(next);
  const auto logarithm = [](double value) { return std::log(std::max(value, kLeastError)); };
  const double high = logarithm(before.error);
  const double share = (high - logarithm(error)) / (high - logarithm(next->error));
  return RayCost{atShare(before.setting, next->setting, share), error,
                 atShare(before.seconds, next->seconds, share)};
}

// Two significant digits, up for counts and down for errors.
double rounded(double value, bool up) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return (up ? std::ceil(value / unit - 1e-6) : std::floor(value / unit + 1e-6)) * unit;
}

struct Combination {
  const EffectsCost& effects;
  const DegreeCost& degree;
  const StorageCost& storage;

  double squaredError() const {
    return effects.error * effects.error + degree.error * degree.error + storage.error * storage.error;
  }
  double values() const { return coefficientCount(degree.degree); }
};

PredictedSettings settle(const Combination& combination, const RayCost& rays, bool adaptive,
                         const BakeRequest& defaults) {
  PredictedSettings predicted{{defaults, combination.storage.storage}, 0, 0};
  BakeRequest& request = predicted.settings.request;
  request.model = combination.effects.model;
  request.bounces = combination.effects.bounces;
  request.degree = combination.degree.degree;
  if (adaptive) {
    request = requestForError(request, rounded(rays.setting, false));
  } else if (rays.setting > 0) {
    request.rays = static_cast<int>(std::lround(rounded(rays.setting, true)));
  }
  predicted.error = std::sqrt(combination.squaredError() + rays.error * rays.error);
  predicted.seconds =
      rays.seconds * combination.effects.secondsFactor + combination.storage.seconds * combination.values();
  return predicted;
}

template <typename Visit>
void forCombinations(const ErrorCosts& costs, const Visit& visit) {
  for (const EffectsCost& effects : costs.effects)
    for (const DegreeCost& degree : costs.degrees)
      for (const StorageCost& storage : costs.storage) visit(Combination{effects, degree, storage});
}

}  // namespace

std::pair<long, double> priceOf(double seconds, double bytes) {
  return {std::lround(std::log(seconds + 0.01) / std::log(1.25)), bytes};
}

std::optional<PredictedSettings> cheapestSettings(const ErrorCosts& costs, double error,
                                                  const BakeRequest& defaults) {
  std::optional<PredictedSettings> best;
  std::pair<long, double> bestPrice;
  forCombinations(costs, [&](const Combination& combination) {
    const double left = error * error - combination.squaredError();
    if (left < 0) return;
    const auto consider = [&](const RayCost& rays, bool adaptive) {
      const PredictedSettings predicted = settle(combination, rays, adaptive, defaults);
      const auto price = priceOf(predicted.seconds, combination.storage.bytes * combination.values());
      if (best && price >= bestPrice) return;
      best = predicted;
      bestPrice = price;
    };
    if (combination.effects.model == "unshadowed") {
      consider({}, false);
      return;
    }
    if (const auto rays = raysFor(costs.rays, std::sqrt(left))) consider(*rays, false);
    if (const auto rays = raysFor(costs.adaptive, std::sqrt(left))) consider(*rays, true);
  });
  return best;
}

PredictedSettings finestSettings(const ErrorCosts& costs, const BakeRequest& defaults) {
  std::optional<PredictedSettings> best;
  forCombinations(costs, [&](const Combination& combination) {
    const bool traces = combination.effects.model != "unshadowed";
    assert(!costs.rays.empty() || !traces);
    const PredictedSettings predicted =
        settle(combination, traces ? costs.rays.back() : RayCost{}, false, defaults);
    if (!best || predicted.error < best->error) best = predicted;
  });
  return *best;
}

}  // namespace shprt
