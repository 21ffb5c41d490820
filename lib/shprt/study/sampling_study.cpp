#include "shprt/study/sampling_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shprt/study/curve_effort.h"
#include "shprt/study/reference.h"
#include "shprt/study/sampling_curve.h"
#include "shprt/study/section_parts.h"

namespace shprt {
namespace {

constexpr int kComparedRays = 256;

struct MeasuredMethod {
  const SamplingMethod* method;
  std::vector<std::pair<double, double>> byRays, bySeconds;  // error against them
  std::optional<double> slope;                               // against rays
};

// Rays that each of the others takes for the error of the lattice.
std::string compare(const std::vector<MeasuredMethod>& methods, StudySection& section) {
  const MeasuredMethod& lattice = methods.back();
  const double error = std::find_if(lattice.byRays.begin(), lattice.byRays.end(), [](const auto& point) {
                         return point.first == kComparedRays;
                       })->second;
  if (error == 0) {
    return fmt::format(
        "{} lattice rays leave no error at all: with the control variate, points that see everything or "
        "nothing are exact.\n",
        kComparedRays);
  }
  std::string text, beyond;
  for (const MeasuredMethod& other : methods) {
    const std::optional<double> rays = raysForError(other.byRays, error);
    if (&other == &lattice || !rays) continue;
    const double ratio = *rays / kComparedRays;
    const auto& [id, name, points, controlVariate] = *other.method;
    section.figures.emplace_back(fmt::format("rays.{}.equal{}", id, kComparedRays), *rays);
    section.figures.emplace_back(fmt::format("rays.{}.ratio{}", id, kComparedRays), ratio);
    text += fmt::format("{}{} {} ({} times)", text.empty() ? "" : "; ", name, shortNumber(*rays),
                        shortNumber(ratio));
    if (*rays > other.byRays.back().first) beyond += (beyond.empty() ? "" : "; ") + name;
  }
  text = fmt::format("{} lattice rays leave an error of {}. Rays that others take for that: {}.",
                     kComparedRays, shortNumber(error), text);
  if (!beyond.empty()) text += " Beyond what was measured, by its slope: " + beyond + ".";
  return text + "\n";
}

std::string describeSlopes(const std::vector<MeasuredMethod>& methods, StudySection& section) {
  std::string text;
  for (const MeasuredMethod& method : methods) {
    if (!method.slope) continue;
    section.figures.emplace_back("slope." + method.method->id, *method.slope);
    text += fmt::format("{}{} {:.2f}", text.empty() ? "" : "; ", method.method->name, *method.slope);
  }
  return text.empty() ? "" : "Error goes with rays to the power of: " + text + ".\n";
}

void addMethods(const std::vector<MeasuredMethod>& methods, const CurveEffort& effort,
                StudySection& section) {
  StudyTable errors{"rays", "Error", {"rays"}, {}}, seconds{"rays-seconds", "Seconds", {"rays"}, {}};
  for (const int rays : effort.rays) {
    errors.rows.push_back({std::to_string(rays)});
    seconds.rows.push_back({std::to_string(rays)});
  }
  StudyChart rayChart =
      beginChart("error-rays", "Error against rays", "rays per vertex", "relative RMS error of transfer");
  StudyChart secondChart = beginChart("error-seconds", "Error against seconds", "seconds of tracing",
                                      "relative RMS error of transfer");
  for (const MeasuredMethod& method : methods) {
    errors.columns.push_back(method.method->name);
    seconds.columns.push_back(method.method->name);
    StudyCurve byRays = beginCurve(method.method->name), bySeconds = byRays;
    for (std::size_t i = 0; i < method.byRays.size(); ++i) {
      const auto [rays, error] = method.byRays[i];
      const bool timed = i < method.bySeconds.size();
      const std::string name = fmt::format("rays.{}.{}.", method.method->id, rays);
      addPoint(byRays, rays, error);
      errors.rows[i].push_back(shortNumber(error));
      seconds.rows[i].push_back(timed ? shortNumber(method.bySeconds[i].first) : "");
      section.figures.emplace_back(name + "error", error);
      if (!timed) continue;
      addPoint(bySeconds, method.bySeconds[i].first, error);
      section.figures.emplace_back(name + "seconds", method.bySeconds[i].first);
    }
    byRays.slope = method.slope;
    bySeconds.slope = fitSlope(beyondFixedCosts(bySeconds.points));
    addCurve(rayChart, std::move(byRays));
    addCurve(secondChart, std::move(bySeconds));
  }
  addChart(section, std::move(rayChart));
  addChart(section, std::move(secondChart));
  section.tables.push_back(std::move(errors));
  section.tables.push_back(std::move(seconds));
}

StudySection measureSection(StudyRun& run) {
  const CurveEffort effort = curveEffort(run.options);
  SamplingMeasurements measurements(run);
  std::vector<MeasuredMethod> methods;
  for (const SamplingMethod& method : samplingMethods()) {
    MeasuredMethod& measured = methods.emplace_back(MeasuredMethod{&method, {}, {}, {}});
    for (const int rays : effort.rays) {
      run.announce(fmt::format("{}, {} rays", method.name, rays));
      const double error = measurements.error(method, rays);
      measured.byRays.emplace_back(rays, error);
      if (const auto seconds = measurements.seconds(method, rays))
        measured.bySeconds.emplace_back(*seconds, error);
    }
    measured.slope = fitSlope(measured.byRays);
  }

  StudySection section = beginSection("rays", "Error against rays");
  addMethods(methods, effort, section);
  section.text = fmt::format(
      "RMS error of shadowed transfer of degree {} at {} vertices drawn from the scene's receivers, relative "
      "to the unshadowed transfer; against a bake of {} lattice rays with another seed. Seconds are what a "
      "bake of the whole scene spends on rays.\n",
      run.options.degree, measurements.sample().vertices().size(), effort.referenceRays);
  section.text += compare(methods, section) + describeSlopes(methods, section);
  return section;
}

}  // namespace

StudyExperiment samplingStudy(const StudyRun& run) {
  const auto settings = samplingMethods().size() * curveEffort(run.options).rays.size();
  return {"rays", static_cast<int>(settings), measureSection};
}

}  // namespace shprt
