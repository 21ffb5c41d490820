#include "shprt/study/pareto.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "shprt/study/measure_costs.h"
#include "shprt/study/pareto_section.h"
#include "shprt/study/study_bake.h"

namespace shprt {
namespace {

constexpr double kTargets[] = {0.1, 0.03, 0.01, 0.003, 0.001};

class ParetoSearch {
 public:
  ParetoSearch(StudyRun& run, StudyReference& reference) : run_(run), reference_(reference) {}

  MeasuredSettings measure(const BakeSettings& settings) {
    const std::vector<double> figures = run_.journal.measure("pareto/bake " + optionsOf(settings), [&] {
      const StudyBake bake = bakeForStudy(run_, settings.request);
      const StoredAsset stored = storeAndRead(bake.asset, settings.storage);
      const LightCoefficients* light = run_.light ? &run_.light->coefficients : nullptr;
      return std::vector<double>{reference_.errorOf(stored.asset), bake.seconds + stored.seconds,
                                 static_cast<double>(stored.bytes), relightSeconds(stored.asset, light)};
    });
    measured_.push_back({settings, figures[0], figures[1], figures[2], figures[3]});
    return measured_.back();
  }

  // Bakes what is predicted to reach the target; where it misses, aims lower.
  void reach(double target, const ErrorCosts& costs, const BakeRequest& defaults) {
    constexpr int kGoes = 3;
    constexpr double kMargin = 0.95;
    double aim = kMargin * target;
    for (int go = 0; go < kGoes; ++go) {
      const std::optional<PredictedSettings> predicted = cheapestSettings(costs, aim, defaults);
      if (!predicted) {
        measure(finestSettings(costs, defaults).settings);
        return;
      }
      const MeasuredSettings result = measure(predicted->settings);
      if (result.error <= target) return;
      aim *= kMargin * target / result.error;
    }
  }

  ParetoRow cheapest(double target) const {
    const auto price = [](const MeasuredSettings& one) { return priceOf(one.seconds, one.bytes); };
    const MeasuredSettings* best = nullptr;
    for (const MeasuredSettings& one : measured_)
      if (one.error <= target && (!best || price(one) < price(*best))) best = &one;
    if (best) return {target, true, *best};
    return {target, false,
            *std::min_element(measured_.begin(), measured_.end(),
                              [](const auto& a, const auto& b) { return a.error < b.error; })};
  }

  std::vector<MeasuredSettings> measured() const { return measured_; }

 private:
  StudyRun& run_;
  StudyReference& reference_;
  std::vector<MeasuredSettings> measured_;
};

BakeSettings defaultSettings(const StudyRun& run) {
  BakeRequest asked;
  asked.rays = run.options.rays;
  asked.seed = run.options.seed;
  asked.error = run.options.error;
  return {followPlan(run.plan, asked), {}};
}

StudySection measureSection(StudyRun& run) {
  StudyReference reference(run);
  // Without the journal's help that is the reference's bake, so it is a step.
  run.announce("the best bake that is affordable");
  const std::vector<double> black = run.journal.measure(
      "pareto/black", [&] { return std::vector<double>{reference.isBlack() ? 1.0 : 0.0}; });
  if (black[0] != 0) return blackParetoSection();
  return paretoSection(run, reference, measurePareto(run, reference));
}

}  // namespace

Pareto measurePareto(StudyRun& run, StudyReference& reference) {
  ParetoSearch search(run, reference);
  Pareto pareto;
  pareto.costs = measureErrorCosts(run, reference);
  run.announce("the default settings");
  pareto.defaults = search.measure(defaultSettings(run));
  BakeRequest defaults;
  defaults.seed = run.options.seed;
  for (const double target : kTargets) {
    run.announce(fmt::format("the cheapest settings for {:g}%", 100 * target));
    search.reach(target, pareto.costs, defaults);
  }
  for (const double target : kTargets) pareto.rows.push_back(search.cheapest(target));
  pareto.measured = search.measured();
  return pareto;
}

StudyExperiment paretoExperiment() {
  constexpr int kSteps = 1 + kCostSteps + 1 + static_cast<int>(std::size(kTargets));
  return {"pareto", kSteps, measureSection};
}

}  // namespace shprt
