#include "shprt/study/run_study.h"

#include <fmt/core.h>

#include <algorithm>

#include "shprt/study/curve_experiments.h"
#include "shprt/study/error_budget.h"
#include "shprt/study/pareto.h"
#include "shprt/study/study_facts.h"
#include "shprt/transfer/stopwatch.h"

namespace shprt {
namespace {

// The few figures that sum a study up, and what they are called then.
constexpr struct {
  const char *figure, *headline;
} kHeadlines[] = {
    {"pareto.default.error", "relative error of the default settings"},
    {"pareto.default.seconds", "seconds that the default settings take"},
    {"pareto.0.1.seconds", "seconds for an error of 10%"},
    {"pareto.0.03.seconds", "seconds for an error of 3%"},
    {"pareto.0.01.seconds", "seconds for an error of 1%"},
    {"pareto.0.003.seconds", "seconds for an error of 0.3%"},
    {"pareto.0.001.seconds", "seconds for an error of 0.1%"},
};

// What was not reached has no cost.
bool isReached(const StudySection& section, const std::string& figure) {
  const std::string reached = figure.substr(0, figure.rfind('.')) + ".reached";
  return std::none_of(section.figures.begin(), section.figures.end(),
                      [&](const auto& other) { return other.first == reached && other.second == 0; });
}

std::vector<std::pair<std::string, double>> pickHeadlines(const std::vector<StudySection>& sections) {
  std::vector<std::pair<std::string, double>> headlines;
  for (const auto& [figure, headline] : kHeadlines)
    for (const StudySection& section : sections)
      for (const auto& [name, value] : section.figures)
        if (name == figure && isReached(section, name)) headlines.emplace_back(headline, value);
  return headlines;
}

}  // namespace

std::vector<StudyExperiment> studyExperiments(const StudyRun& run) {
  std::vector<StudyExperiment> experiments = curveExperiments(run);
  experiments.push_back(errorBudget());
  experiments.push_back(paretoExperiment());
  return experiments;
}

int countSteps(const std::vector<StudyExperiment>& experiments) {
  int steps = 0;
  for (const StudyExperiment& experiment : experiments) steps += experiment.steps;
  return steps;
}

Study runStudy(StudyRun& run, const std::vector<StudyExperiment>& experiments) {
  const Stopwatch watch;
  Study study;
  study.title = "What accuracy costs: " + run.scene;
  study.facts = studyFacts(run);
  for (const StudyExperiment& experiment : experiments) study.sections.push_back(experiment.measure(run));
  study.headlines = pickHeadlines(study.sections);
  // Measured last, and what most come for.
  const auto settings = std::find_if(study.sections.begin(), study.sections.end(),
                                     [](const StudySection& section) { return section.id == "pareto"; });
  if (settings != study.sections.end()) std::rotate(study.sections.begin(), settings, std::next(settings));
  std::string duration = fmt::format("{:.1f} s", watch.seconds());
  if (run.journal.fromBefore() > 0)
    duration += fmt::format("; {} of the measurements were there from before", run.journal.fromBefore());
  study.facts.emplace_back("duration", duration);
  return study;
}

}  // namespace shprt
