#include "shprt/report/plot_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shprt {
namespace {

constexpr std::array<double, 3> kSteps = {1, 2, 5};
constexpr double kRounding = 1e-9;  // relative: a value on a step belongs to it
constexpr int kMostLabels = 10;
constexpr double kGreatest = 1e308;  // an axis ends there: its next step is no double

// 1, 2 and 5 times powers of ten by their number: step(0) = 1, step(1) = 2, step(3) = 10, step(-1) = 0.5.
double step(int number) {
  const int decade = static_cast<int>(std::floor(number / 3.0));
  // Powers of ten below one are not exact, their reciprocals are.
  const double digit = kSteps[static_cast<std::size_t>(number - 3 * decade)];
  return decade < 0 ? digit / std::pow(10.0, -decade) : digit * std::pow(10.0, decade);
}

int lastStepUpTo(double value) {
  int number = 3 * static_cast<int>(std::floor(std::log10(value))) - 1;
  while (step(number + 1) <= value * (1 + kRounding)) ++number;
  return number;
}

int firstStepFrom(double value) {
  const int number = lastStepUpTo(value);
  return step(number) >= value * (1 - kRounding) ? number : number + 1;
}

// In the notation that gnuplot typesets where it is long.
std::string label(double value) {
  const double exponent = std::log10(value);
  const bool wholeDecade = std::abs(exponent - std::round(exponent)) < kRounding;
  if (wholeDecade && (value < 0.9e-3 || value > 1.1e4)) return fmt::format("10^{{{:.0f}}}", exponent);
  return fmt::format("{:g}", value);
}

PlotAxis logarithmicAxis(double low, double high) {
  PlotAxis axis;
  int first = lastStepUpTo(low), last = firstStepFrom(high);
  if (first == last) --first, last += high < kGreatest / 10 ? 1 : 0;
  int stride = 1;
  if (last - first >= kMostLabels) {  // decades, or every so many of them
    first = 3 * static_cast<int>(std::floor(first / 3.0)), last = 3 * static_cast<int>(std::ceil(last / 3.0));
    stride = 3 * std::max(1, ((last - first) / 3 + kMostLabels - 1) / kMostLabels);
  }
  axis.low = step(first), axis.high = step(last);
  for (int number = first; number <= last; number += stride)
    axis.tics.emplace_back(step(number), label(step(number)));
  return axis;
}

PlotAxis linearAxis(double low, double high) {
  constexpr int kSpaces = 6;
  PlotAxis axis;
  axis.logarithmic = false;
  if (low > 0 && low < 0.5 * high) low = 0;  // zero is worth seeing where it is near
  const double size = std::max(std::abs(low), std::abs(high));
  if (!(high - low > kRounding * size)) {
    const double margin = size > 0 ? 0.1 * size : 1;
    low -= margin, high += margin;
  }
  const double space = step(firstStepFrom(high / kSpaces - low / kSpaces));
  const double first = std::floor(low / space + kRounding), last = std::ceil(high / space - kRounding);
  axis.low = first * space, axis.high = last * space;
  for (double number = first; number <= last; ++number)
    axis.tics.emplace_back(number * space, fmt::format("{:.10g}", number * space));
  return axis;
}

}  // namespace

double PlotAxis::place(double value) const {
  return std::isnan(value) ? value : std::clamp(value, low, high);
}

PlotAxis chooseAxis(const std::vector<double>& values, bool logarithmic, std::optional<double> low,
                    std::optional<double> high) {
  double least = INFINITY, greatest = -INFINITY;
  for (const double value : values) {
    if (!std::isfinite(value) || (logarithmic && !(value >= std::numeric_limits<double>::min()))) continue;
    const double within = std::clamp(value, -kGreatest, kGreatest);
    least = std::min(least, within), greatest = std::max(greatest, within);
  }
  if (!(least <= greatest)) least = logarithmic ? 1 : 0, greatest = logarithmic ? 10 : 1;
  if (low) least = *low, greatest = std::max(greatest, least);
  if (high) greatest = *high, least = std::min(least, greatest);
  return logarithmic ? logarithmicAxis(least, greatest) : linearAxis(least, greatest);
}

}  // namespace shprt
