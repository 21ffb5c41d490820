#include "shprt/study/pareto_section.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <string>

namespace shprt {
namespace {

// Three significant digits, of the unit that keeps them short.
std::string formatSeconds(double seconds) {
  if (seconds >= 1) return fmt::format("{:.3g} s", seconds);
  if (seconds >= 1e-3) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} µs", seconds * 1e6);
}

std::string formatSize(double bytes) {
  if (bytes >= 1e9) return fmt::format("{:.3g} GB", bytes / 1e9);
  if (bytes >= 1e6) return fmt::format("{:.3g} MB", bytes / 1e6);
  return fmt::format("{:.3g} kB", bytes / 1e3);
}

std::string formatPercent(double share) {
  return fmt::format("{:.2g}%", 100 * share);
}

StudySection emptySection() {
  StudySection section;
  section.id = "pareto";
  section.title = "What accuracy costs at least";
  return section;
}

std::string assetName(const ParetoRow& row) {
  return fmt::format("asset-{:g}.prt.exr", row.target);
}

std::vector<std::string> cells(const StudyRun& run, const std::string& label,
                               const MeasuredSettings& measured, const std::string& output) {
  return {label,
          formatPercent(measured.error),
          formatSeconds(measured.seconds),
          formatSize(measured.bytes),
          formatSeconds(measured.relightSeconds),
          bakeCommand(run, measured.settings, output)};
}

StudyTable makeTable(const StudyRun& run, const Pareto& pareto) {
  StudyTable table{"pareto", "The cheapest settings for each error", {}, {}};
  table.columns = {"error wanted", "error", "bake", "asset", "relight", "command"};
  table.rows.push_back(cells(run, "defaults", pareto.defaults, "asset-defaults.prt.exr"));
  for (const ParetoRow& row : pareto.rows) {
    const std::string label = fmt::format("{:g}%", 100 * row.target);
    if (row.reached) {
      table.rows.push_back(cells(run, label, row.best, assetName(row)));
    } else {
      table.rows.push_back({label, "out of reach", "", "", "", ""});
    }
  }
  if (!pareto.rows.back().reached)
    table.rows.push_back(cells(run, "the best", pareto.rows.back().best, "asset-best.prt.exr"));
  return table;
}

StudyChart makeChart(const Pareto& pareto) {
  StudyChart chart;
  chart.id = "pareto";
  chart.title = "The least time for an error";
  chart.xLabel = "seconds to bake and write";
  chart.yLabel = "relative RMS error";
  StudyCurve cheapest{"cheapest settings", {}, {}};
  for (const ParetoRow& row : pareto.rows)
    if (row.reached) cheapest.points.emplace_back(row.best.seconds, row.best.error);
  const auto last = std::unique(cheapest.points.begin(), cheapest.points.end());
  cheapest.points.erase(last, cheapest.points.end());
  chart.curves = {cheapest, {"defaults", {{pareto.defaults.seconds, pareto.defaults.error}}, {}}};
  return chart;
}

void addFigures(const std::string& name, const MeasuredSettings& measured, StudySection& section) {
  const BakeRequest& request = measured.settings.request;
  const auto add = [&](const char* figure, double value) {
    section.figures.emplace_back("pareto." + name + "." + figure, value);
  };
  add("error", measured.error);
  add("seconds", measured.seconds);
  add("bytes", measured.bytes);
  add("relightSeconds", measured.relightSeconds);
  add("degree", request.degree);
  if (request.model == "unshadowed") {
    add("rays", 0);
  } else if (request.samplingError) {
    add("errorAskedFor", errorAskedFor(request));
  } else {
    add("rays", request.rays);
  }
}

std::string describeReference(const StudyRun& run, const StudyReference& reference) {
  std::string text;
  if (run.light) {
    text = fmt::format(
        "Errors are those of the radiance of all vertices under {}: RMS of the difference over RMS, against "
        "the best bake that is affordable here, of degree {}",
        run.light->name, reference.degree());
  } else {
    text = fmt::format(
        "Errors are those of the transfer of degree {}, which is held fixed because no light is given (name "
        "one, and the degree is chosen, too): RMS over vertices of the error's norm over that of the "
        "unshadowed "
        "transfer, against the best bake that is affordable here",
        reference.degree());
  }
  if (reference.traces())
    text +=
        fmt::format(", with {} rays per vertex of another seed, and bounces until less than {:g}% is left",
                    reference.rays(), 100 * reference.bounceError());
  text +=
      ". Times are of tracing, bounces and writing; loading the scene is not among them. Of settings whose "
      "times differ by less than a quarter or 10 ms, the smaller asset is taken.\n";
  return text +
         "What vertices cannot hold is in the reference, too, and so not in these errors: light is "
         "interpolated "
         "between them, in pictures and where it is gathered for bounces. A finer mesh cures it (--max-edge "
         "auto).\n";
}

// What the finest settings still leave, by its sources.
std::string describeLimits(const ErrorCosts& costs) {
  const DegreeCost& degree = costs.degrees.back();
  std::string text = "; predicted at best from rays alone: ";
  text += costs.rays.empty() ? "nothing" : formatPercent(costs.rays.back().error);
  if (degree.error > 0)
    text += fmt::format(", from bands beyond degree {}: {}", degree.degree, formatPercent(degree.error));
  return text;
}

std::string describeFindings(const StudyRun& run, const StudyReference& reference, const Pareto& pareto) {
  std::string text;
  if (!reference.traces())
    text += "Nothing stands above any vertex, so the unshadowed model is exact and no ray is needed.\n";
  const auto& rows = pareto.rows;
  const auto lost = std::find_if(rows.begin(), rows.end(), [](const ParetoRow& row) { return !row.reached; });
  if (lost != rows.end()) {
    text += fmt::format("{:g}% {} out of reach of what this study could try; the best has {}{}.{}\n",
                        100 * lost->target, std::next(lost) == rows.end() ? "is" : "and less are",
                        formatPercent(lost->best.error), describeLimits(pareto.costs),
                        run.options.quick ? " Without --quick it tries more." : "");
  }
  const MeasuredSettings& defaults = pareto.defaults;
  const auto as = std::find_if(rows.rbegin(), rows.rend(), [&](const ParetoRow& row) {
    return row.reached && row.best.seconds < defaults.seconds && row.best.error <= defaults.error;
  });
  text += fmt::format("The defaults have an error of {} and take {}", formatPercent(defaults.error),
                      formatSeconds(defaults.seconds));
  if (as != rows.rend())
    text += fmt::format("; the settings found for {:g}% have {} and take {}", 100 * as->target,
                        formatPercent(as->best.error), formatSeconds(as->best.seconds));
  return text + ".\n";
}

}  // namespace

StudySection paretoSection(const StudyRun& run, const StudyReference& reference, const Pareto& pareto) {
  StudySection section = emptySection();
  section.text = describeReference(run, reference) + describeFindings(run, reference, pareto);
  if (run.light)
    section.text += fmt::format("To relight an asset: shprt relight ASSET.prt.exr {} -o radiance.csv\n",
                                run.light->arguments);
  section.charts = {makeChart(pareto)};
  section.tables = {makeTable(run, pareto)};
  addFigures("default", pareto.defaults, section);
  for (const ParetoRow& row : pareto.rows) {
    const std::string name = fmt::format("{:g}", row.target);
    section.figures.emplace_back("pareto." + name + ".reached", row.reached ? 1 : 0);
    addFigures(name, row.best, section);
  }
  return section;
}

StudySection blackParetoSection() {
  StudySection section = emptySection();
  section.missing =
      "nothing is lit, or nothing reflects: there is no radiance for an error to be relative to";
  return section;
}

}  // namespace shprt
