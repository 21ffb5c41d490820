// The parts of a section: begun with their names, and filled with what their axes can show.
#pragma once

#include <string>
#include <utility>

#include "shprt/study/study.h"

namespace shprt {

inline StudySection beginSection(std::string id, std::string title) {
  StudySection section;
  section.id = std::move(id);
  section.title = std::move(title);
  return section;
}

// Logarithmic along both axes.
inline StudyChart beginChart(std::string id, std::string title, std::string xLabel, std::string yLabel) {
  StudyChart chart;
  chart.id = std::move(id);
  chart.title = std::move(title);
  chart.xLabel = std::move(xLabel);
  chart.yLabel = std::move(yLabel);
  return chart;
}

// Without points.
inline StudyCurve beginCurve(std::string name) {
  StudyCurve curve;
  curve.name = std::move(name);
  return curve;
}

// Errors are shown along logarithmic axes, on which nothing is zero: those points are left out,
inline void addPoint(StudyCurve& curve, double x, double error) {
  if (error > 0) curve.points.emplace_back(x, error);
}
// curves without points,
inline void addCurve(StudyChart& chart, StudyCurve curve) {
  if (!curve.points.empty()) chart.curves.push_back(std::move(curve));
}
// and charts without curves.
inline void addChart(StudySection& section, StudyChart chart) {
  if (!chart.curves.empty()) section.charts.push_back(std::move(chart));
}

// As people read numbers: two significant digits, and no exponent where a number is 10 or more.
std::string shortNumber(double number);

}  // namespace shprt
