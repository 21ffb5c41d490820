#include "shprt/study/adaptive_study.h"

#include <fmt/format.h>

#include <algorithm>

#include "shprt/study/curve_effort.h"
#include "shprt/study/reference.h"
#include "shprt/study/sampling_curve.h"
#include "shprt/study/section_parts.h"
#include "shprt/transfer/planned_bake.h"
#include "shprt/transfer/stopwatch.h"

namespace shprt {
namespace {

// Below the rays that the same number everywhere would take: what is hoped for when bakes are chosen that the
// effort allows.
constexpr double kExpectedSaving = 3;

struct Adaptive {
  double asked = 0;
  double error = 0;  // against the reference
  double bound = 0;  // that the bake claims
  double seconds = 0;
  double meanRays = 0;
};

Adaptive measureAdaptive(StudyRun& run, SamplingMeasurements& measurements, double asked) {
  const std::string key = fmt::format("adaptive: error {}, {}", asked, measurements.referenceName());
  const std::vector<double> measured = run.journal.measure(key, [&] {
    const BakeRequest request{.model = "shadowed",
                              .degree = run.options.degree,
                              .rays = run.options.rays,
                              .seed = run.options.seed,
                              .samplingError = asked};
    Bake bake;
    const double seconds = bestSeconds([&] {
      const Stopwatch watch;
      bake = bakeRequested(measurements.shadowScene(), request);
      return watch.seconds();
    });
    const double error = measurements.errorOf(selectColumns(bake.transfer, measurements.sample().vertices()));
    const double meanRays =
        shareOf(static_cast<double>(bake.statistics.rays), static_cast<double>(bake.statistics.samplePoints));
    return std::vector{error, bake.statistics.sampling.errorBound, seconds, meanRays};
  });
  return {asked, measured[0], measured[1], measured[2], measured[3]};
}

// The error of the lattice with the same rays everywhere, by rays and by seconds.
struct Uniform {
  std::vector<std::pair<double, double>> byRays, bySeconds;
  std::vector<std::pair<double, double>> secondsByRays;

  // That so many rays take: linear in rays.
  std::optional<double> secondsOf(double rays) const {
    if (secondsByRays.size() < 2) return {};
    std::size_t next = 1;
    while (next + 1 < secondsByRays.size() && secondsByRays[next].first < rays) ++next;
    const auto [rays0, seconds0] = secondsByRays[next - 1];
    const auto [rays1, seconds1] = secondsByRays[next];
    return std::max(0.0, seconds0 + (rays - rays0) * (seconds1 - seconds0) / (rays1 - rays0));
  }
};

Uniform measureUniform(SamplingMeasurements& measurements, const CurveEffort& effort) {
  const SamplingMethod& lattice = samplingMethods().back();
  Uniform uniform;
  for (const int rays : effort.rays) {
    const double error = measurements.error(lattice, rays);
    uniform.byRays.emplace_back(rays, error);
    if (const auto seconds = measurements.seconds(lattice, rays)) {
      uniform.bySeconds.emplace_back(*seconds, error);
      uniform.secondsByRays.emplace_back(rays, *seconds);
    }
  }
  return uniform;
}

std::string describe(const std::vector<Adaptive>& bakes, const Uniform& uniform, StudySection& section) {
  double least = bakes.front().error / bakes.front().asked, most = least;
  for (const Adaptive& bake : bakes) {
    least = std::min(least, bake.error / bake.asked);
    most = std::max(most, bake.error / bake.asked);
  }
  if (most == 0) return "Nothing stands above any vertex: transfer is exact without a ray.\n";
  section.figures.emplace_back("adaptive.leastRatio", least);
  section.figures.emplace_back("adaptive.mostRatio", most);
  std::string text = fmt::format("The true error came out between {} and {} times the one asked for{}.\n",
                                 shortNumber(least), shortNumber(most), most <= 1 ? ", never above it" : "");
  const Adaptive& finest = bakes.back();
  const auto rays = raysForError(uniform.byRays, finest.error);
  if (!rays || !(finest.meanRays > 0)) return text;
  section.figures.emplace_back("adaptive.raysSaved", *rays / finest.meanRays);
  text += fmt::format(
      "Asked for {}, it took {} rays per point on average; for the error it achieved, the same number "
      "everywhere would have to be {}, which is {} times as many",
      shortNumber(finest.asked), shortNumber(finest.meanRays), shortNumber(*rays),
      shortNumber(*rays / finest.meanRays));
  const auto seconds = uniform.secondsOf(*rays);
  if (seconds && finest.seconds > 0) {
    section.figures.emplace_back("adaptive.secondsSaved", *seconds / finest.seconds);
    text += fmt::format(", and would take {} s instead of {} s, {} times as long", shortNumber(*seconds),
                        shortNumber(finest.seconds), shortNumber(*seconds / finest.seconds));
  }
  return text + ".\n";
}

using Points = std::vector<std::pair<double, double>>;

// Slopes are of the points that `fitted` picks.
StudyChart makeChart(const std::string& id, std::string xLabel, StudyCurve adaptive, const Points& uniform,
                     Points (*fitted)(Points)) {
  StudyChart chart = beginChart("adaptive-" + id, "Adaptive rays: error against " + id, std::move(xLabel),
                                "relative RMS error of transfer");
  adaptive.slope = fitSlope(fitted(adaptive.points));
  addCurve(chart, std::move(adaptive));
  StudyCurve same = beginCurve("the same rays everywhere");
  for (const auto& [x, error] : uniform) addPoint(same, x, error);
  same.slope = fitSlope(fitted(same.points));
  addCurve(chart, std::move(same));
  return chart;
}

void addBakes(const std::vector<Adaptive>& bakes, const Uniform& uniform, StudySection& section) {
  StudyTable table{"adaptive",
                   "Bakes by error",
                   {"asked", "achieved", "achieved / asked", "claimed bound", "rays per point", "seconds"},
                   {}};
  StudyCurve bySeconds = beginCurve("adaptive"), byRays = bySeconds;
  for (const Adaptive& bake : bakes) {
    const double ratio = bake.error / bake.asked;
    table.rows.push_back({shortNumber(bake.asked), shortNumber(bake.error), shortNumber(ratio),
                          shortNumber(bake.bound), shortNumber(bake.meanRays), shortNumber(bake.seconds)});
    addPoint(bySeconds, bake.seconds, bake.error);
    addPoint(byRays, bake.meanRays, bake.error);
    const std::string name = fmt::format("adaptive.{}.", bake.asked);
    section.figures.insert(section.figures.end(), {{name + "error", bake.error},
                                                   {name + "ratio", ratio},
                                                   {name + "bound", bake.bound},
                                                   {name + "rays", bake.meanRays},
                                                   {name + "seconds", bake.seconds}});
  }
  addChart(section,
           makeChart("seconds", "seconds", std::move(bySeconds), uniform.bySeconds, beyondFixedCosts));
  addChart(section, makeChart("rays", "rays per point", std::move(byRays), uniform.byRays,
                              [](Points points) { return points; }));
  section.tables.push_back(std::move(table));
}

StudySection measureSection(StudyRun& run) {
  const CurveEffort effort = curveEffort(run.options);
  SamplingMeasurements measurements(run);
  run.announce("the lattice, to compare");
  const Uniform uniform = measureUniform(measurements, effort);

  std::vector<Adaptive> bakes;
  std::string tooMany;
  for (const double asked : effort.errors) {
    run.announce(fmt::format("rays for an error of {}", asked));
    const auto predicted = raysForError(uniform.byRays, asked);
    if (!predicted || measurements.affordable(*predicted / kExpectedSaving))
      bakes.push_back(measureAdaptive(run, measurements, asked));
    else
      tooMany += (tooMany.empty() ? "" : ", ") + shortNumber(asked);
  }
  StudySection section = beginSection("adaptive", "Error asked for, error achieved");
  if (bakes.empty()) {
    section.missing = "the scene has too many vertices to bake it with errors of " + tooMany + " here";
    return section;
  }
  section.text = fmt::format(
      "Shadowed transfer of degree {} with as many rays for each vertex as an error that is asked for takes; "
      "the true error is measured at {} vertices against {} rays.",
      run.options.degree, measurements.sample().vertices().size(), effort.referenceRays);
  if (!tooMany.empty()) section.text += " Errors of " + tooMany + " were left out: they take too many rays.";
  section.text += "\n" + describe(bakes, uniform, section);
  addBakes(bakes, uniform, section);
  return section;
}

}  // namespace

StudyExperiment adaptiveStudy(const StudyRun& run) {
  return {"adaptive", 1 + static_cast<int>(curveEffort(run.options).errors.size()), measureSection};
}

}  // namespace shprt
