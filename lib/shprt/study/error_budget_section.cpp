// The error budget in words, tables and bars.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "shprt/study/error_budget.h"

namespace shprt {
namespace {

struct Source {
  std::string id, name, cure;
  double error;
};

std::vector<Source> sourcesOf(const ErrorBudget& budget) {
  return {
      {"truncation", fmt::format("truncation to degree {}", budget.degree),
       "a higher degree, or a smoother light", budget.truncation},
      {"sampling", fmt::format("sampling, {} rays", budget.rays), "more rays", budget.sampling},
      {"bounces", "bounces and effects left out", "a smaller error that they may leave out", budget.bounces},
      {"gathering", "bounced light gathered between vertices", "a finer mesh", budget.gathering},
      {"rounding", "storage as float", "nothing", budget.rounding}};
}

std::string percent(double share) {
  const double number = 100 * share;
  return fmt::format("{:.{}f}%", number, std::fabs(number) < 1 ? 2 : 1);
}

std::string relative(double error) {
  return error == 0 ? "0" : error < 1e-4 ? fmt::format("{:.1e}", error) : fmt::format("{:.3g}%", 100 * error);
}

std::string bar(double share) {
  const auto blocks = static_cast<int>(std::lround(40 * std::clamp(share, 0.0, 1.0)));
  std::string text;
  for (int i = 0; i < blocks; ++i) text += "█";
  return text;
}

double shareOf(double square, double total) {
  return total > 0 ? square / (total * total) : 0;
}

StudyTable vertexTable(const ErrorBudget& budget, const std::vector<Source>& sources) {
  StudyTable table{"error-budget-vertices",
                   "At vertices: default settings against truth",
                   {"source", "relative RMS", "share of the square", ""},
                   {}};
  for (const Source& source : sources) {
    const double share = shareOf(source.error * source.error, budget.total);
    table.rows.push_back({source.name, relative(source.error), percent(share), bar(share)});
  }
  const double unexplained = shareOf(budget.unexplained(), budget.total);
  table.rows.push_back({"left over: sources that add up or cancel",
                        relative(std::sqrt(std::fabs(budget.unexplained()))), percent(unexplained),
                        bar(unexplained)});
  table.rows.push_back({"all", relative(budget.total), "100%", ""});
  table.rows.push_back({"storage as half would add", relative(budget.half),
                        percent(shareOf(budget.half * budget.half, budget.total)), ""});
  table.rows.push_back({"noise of truth, taken out", relative(budget.noise),
                        percent(shareOf(budget.noise * budget.noise, budget.total)), ""});
  return table;
}

StudyTable insideTable(const ErrorBudget& budget) {
  StudyTable table{"error-budget-inside",
                   "Inside triangles: radiance interpolated between vertices against truth there",
                   {"source", "relative RMS", "share of the square", ""},
                   {}};
  const auto add = [&](const std::string& name, double error) {
    const double share = shareOf(error * error, budget.totalInside);
    table.rows.push_back({name, relative(error), percent(share), bar(share)});
  };
  add("interpolation between vertices, gathering included", budget.interpolation);
  add(fmt::format("truncation to degree {}", budget.degree), budget.truncationInside);
  table.rows.push_back({"all", relative(budget.totalInside), "100%", ""});
  table.rows.push_back({"noise of truth, taken out", relative(budget.noiseInside),
                        percent(shareOf(budget.noiseInside * budget.noiseInside, budget.totalInside)), ""});
  return table;
}

std::string textOf(const ErrorBudget& budget, const std::vector<Source>& sources) {
  std::string text = fmt::format(
      "Truth is path-traced radiance under the whole light, without harmonics, at {} vertices and at {} "
      "points uniform over the triangles; its standard error is {} and {} of the radiance's RMS, and taken "
      "out in squares. Truncation is what the path tracer sees change when the light is cut off at the "
      "degree; gathering is what is left between bakes with all bounces and truth under the light's bands "
      "of that degree; sampling is told from it by two bakes with independent rays, {} and {}.\n",
      budget.vertices, budget.samples, relative(budget.noise), relative(budget.noiseInside), budget.rays,
      budget.manyRays);
  if (!(budget.total > 0)) return text + "At vertices no error was found beyond the noise of truth.\n";
  if (budget.noise > budget.total)
    return text + fmt::format(
                      "At vertices the error is about {}, less than the noise of truth: what causes it "
                      "cannot be told from this.\n",
                      relative(budget.total));
  const auto largest = std::max_element(sources.begin(), sources.end(),
                                        [](const Source& a, const Source& b) { return a.error < b.error; });
  const double square = largest->error * largest->error, total = budget.total * budget.total;
  text += fmt::format(
      "At vertices the error is {}; {} has {} of its square. What would help is {}: without that source "
      "{} would be left, and nothing else can bring the error below {}.\n",
      relative(budget.total), largest->name, percent(square / total), largest->cure,
      relative(std::sqrt(std::max(0.0, total - square))), relative(largest->error));
  if (budget.totalInside > 0)
    text += fmt::format(
        "Inside triangles the error is {}, of which interpolation between vertices has {} of the square.\n",
        relative(budget.totalInside),
        percent(shareOf(budget.interpolation * budget.interpolation, budget.totalInside)));
  return text;
}

}  // namespace

StudySection describeErrorBudget(const ErrorBudget& budget) {
  const std::vector<Source> sources = sourcesOf(budget);
  StudySection section;
  section.id = "error-budget";
  section.title = kErrorBudgetTitle;
  section.text = textOf(budget, sources);
  section.tables = {vertexTable(budget, sources), insideTable(budget)};
  const auto add = [&](const std::string& name, double number) {
    section.figures.emplace_back("error-budget." + name, number);
  };
  for (const Source& source : sources) add(source.id, source.error);
  add("total", budget.total);
  add("half", budget.half);
  add("noise", budget.noise);
  add("unexplained-square", budget.unexplained());
  add("interpolation", budget.interpolation);
  add("truncation-inside", budget.truncationInside);
  add("total-inside", budget.totalInside);
  add("noise-inside", budget.noiseInside);
  return section;
}

}  // namespace shprt
