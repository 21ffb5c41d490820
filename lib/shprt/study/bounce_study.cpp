#include "shprt/study/bounce_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shprt/study/curve_effort.h"
#include "shprt/study/reference.h"
#include "shprt/study/section_parts.h"
#include "shprt/transfer/bake.h"

namespace shprt {
namespace {

constexpr double kConvergedError = 1e-6;

struct BounceMeasurement {
  double transferError = 0;
  double emissionError = 0;  // relative to the radiance of the scene's own lights
  double seconds = 0;        // of bouncing, without the rays
  int bounces = 0;
};

class BounceMeasurements {
 public:
  explicit BounceMeasurements(StudyRun& run)
      : run_(run),
        receivers_(receiverVertices(run.prepared.scene)),
        scale_(unshadowedRms(run.prepared.scene, receivers_, run.options.degree)),
        converged_([this] { return bake({}, kConvergedError); }) {
    const std::uint64_t points = std::max<std::uint64_t>(tracedPoints(run.prepared), 1);
    const auto affordable = curveEffort(run.options).bounceRays / points;
    rays_ = std::clamp(static_cast<int>(std::min<std::uint64_t>(affordable, 1 << 20)), 16,
                       std::max(run.options.rays, 16));
  }

  int rays() const { return rays_; }

  // bounces: none for those that bakes take by themselves.
  BounceMeasurement measure(std::optional<int> bounces) {
    const double error = run_.options.error;
    const std::string key = fmt::format("bounces: {}, {} rays, degree {}, seed {}",
                                        bounces ? std::to_string(*bounces) : fmt::format("auto to {}", error),
                                        rays_, run_.options.degree, run_.options.seed);
    const std::vector<double> numbers = run_.journal.measure(key, [&] {
      const Bake baked = bake(bounces, error);
      const Bake& converged = converged_.get();
      return std::vector{shareOf(rmsDifference(baked.transfer, converged.transfer), scale_),
                         radianceError(baked.emission, converged.emission), baked.statistics.bounceSeconds,
                         static_cast<double>(baked.statistics.bounces.size())};
    });
    return {numbers[0], numbers[1], numbers[2], static_cast<int>(numbers[3])};
  }

 private:
  Bake bake(std::optional<int> bounces, double error) const {
    Bake baked = bakeInterreflected(run_.prepared, {.degree = run_.options.degree,
                                                    .rays = rays_,
                                                    .seed = run_.options.seed,
                                                    .bounces = bounces,
                                                    .error = error});
    baked.transfer = selectColumns(baked.transfer, receivers_);
    return baked;
  }

  StudyRun& run_;
  std::vector<std::uint32_t> receivers_;
  double scale_;
  int rays_ = 16;
  Lazy<Bake> converged_;
};

StudySection measureSection(StudyRun& run) {
  StudySection section = beginSection("bounces", "Error against bounces");
  if (run.plan.model != "interreflected") {
    section.missing =
        fmt::format("nothing bounces here: the plan finds {} transfer enough ({})", run.plan.model,
                    run.plan.findings.empty() ? "" : run.plan.finding("interreflection").evidence);
    return section;
  }
  const CurveEffort effort = curveEffort(run.options);
  const bool emits = run.prepared.scene.emits();
  BounceMeasurements measurements(run);
  StudyTable table{"bounces", "What stopping early leaves out", {"bounces", "error of transfer"}, {}};
  if (emits) table.columns.push_back("error of emission");
  table.columns.push_back("seconds of bouncing");
  StudyCurve fixed = beginCurve("transfer"), emission = beginCurve("the scene's own light"),
             chosen = beginCurve("auto");
  const auto note = [&](const std::string& name, const std::string& id, const BounceMeasurement& measured) {
    std::vector<std::string>& row = table.rows.emplace_back();
    row = {name, shortNumber(measured.transferError)};
    section.figures.emplace_back("bounces." + id + ".error", measured.transferError);
    if (emits) {
      row.push_back(shortNumber(measured.emissionError));
      section.figures.emplace_back("bounces." + id + ".emissionError", measured.emissionError);
    }
    row.push_back(shortNumber(measured.seconds));
  };
  for (int bounces = 0; bounces <= effort.bounces; ++bounces) {
    run.announce(fmt::format("{} bounces", bounces));
    const BounceMeasurement measured = measurements.measure(bounces);
    note(std::to_string(bounces), std::to_string(bounces), measured);
    addPoint(fixed, bounces, measured.transferError);
    addPoint(emission, bounces, measured.emissionError);
  }
  run.announce("bounces as the bake chooses");
  const BounceMeasurement automatic = measurements.measure({});
  note(fmt::format("auto ({})", automatic.bounces), "auto", automatic);
  section.figures.emplace_back("bounces.auto.bounces", automatic.bounces);
  addPoint(chosen, automatic.bounces, automatic.transferError);

  section.text = fmt::format(
      "What is missing of transfer of degree {} after so many bounces, over that of the unshadowed transfer; "
      "against light that has bounced until {} remains, of the same {} rays per vertex.\n",
      run.options.degree, kConvergedError, measurements.rays());
  const double none = section.figures.front().second;
  section.text += fmt::format(
      "Without bounces {} is missing. Asked for {}, the bake took {} bounces and was off by {}.\n",
      shortNumber(none), shortNumber(run.options.error), automatic.bounces,
      shortNumber(automatic.transferError));
  StudyChart chart =
      beginChart("error-bounces", "Error against bounces", "bounces", "relative RMS error of transfer");
  chart.logX = false;
  addCurve(chart, std::move(fixed));
  addCurve(chart, std::move(emission));
  addCurve(chart, std::move(chosen));
  addChart(section, std::move(chart));
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace

StudyExperiment bounceStudy(const StudyRun& run) {
  const int steps = run.plan.model == "interreflected" ? curveEffort(run.options).bounces + 2 : 0;
  return {"bounces", steps, measureSection};
}

}  // namespace shprt
