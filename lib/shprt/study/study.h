// A study: what accuracy costs in time, measured on one scene. Plain data between those who measure and those
// who write the page and the JSON.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shprt {

struct StudyCurve {
  std::string name;                               // in the legend
  std::vector<std::pair<double, double>> points;  // x, y, in the order in which they are joined
  std::optional<double> slope;                    // fitted in log-log: y ~ x^slope; where it makes sense
};

struct StudyChart {
  std::string id;     // for file names and JSON: "error-rays"
  std::string title;  // one line
  std::string xLabel, yLabel;
  bool logX = true, logY = true;
  std::vector<StudyCurve> curves;
};

// Cells are text as people read it; numbers for machines are in StudySection::figures.
struct StudyTable {
  std::string id, title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

// One question and its answer.
struct StudySection {
  std::string id, title;
  std::string text;  // what was measured, against what, and what it shows; paragraphs end in "\n"
  std::vector<StudyChart> charts;
  std::vector<StudyTable> tables;
  // The section's numbers by name, in their order of making: ("pareto.0.01.seconds", 1.2), ...
  std::vector<std::pair<std::string, double>> figures;
  std::string missing;  // why the section has nothing to show, one line; "" where it has
};

struct Study {
  std::string title;                                        // the scene's name
  std::vector<std::pair<std::string, std::string>> facts;   // scene, light, machine, version, settings
  std::vector<std::pair<std::string, double>> headlines{};  // the few numbers that sum it up
  std::vector<StudySection> sections;
};

// Least-squares slope of log y over log x; nothing for fewer than two points with x, y > 0.
std::optional<double> fitSlope(const std::vector<std::pair<double, double>>& points);

// The points (seconds, error) at which what every vertex costs whatever its rays is at most half of the time:
// those that take twice as long as the shortest.
std::vector<std::pair<double, double>> beyondFixedCosts(std::vector<std::pair<double, double>> points);

}  // namespace shprt
