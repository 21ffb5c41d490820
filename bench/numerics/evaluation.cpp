// Evaluation: error over degree, over the distance to the pole, and of gradients.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "bench/numerics/peers.h"
#include "bench/numerics/quad.h"
#include "bench/numerics/sections.h"
#include "shprt/report/gnuplot.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/evaluate_batch.h"
#include "shprt/sh/gradient.h"

namespace shprt::numerics {
namespace {

constexpr int kHighest = 1000, kHighestFloat = 32;

// Directions all over the sphere, on the axes, and beside them.
std::vector<Vec3d> directions() {
  std::vector<Vec3d> all = {{0, 0, 1}, {0, 0, -1},           {1, 0, 0},
                            {0, 1, 0}, normalize({1, 1, 1}), normalize({1, 1e-9, 0})};
  for (const double tilt : {1e-12, 1e-6, 1e-3, 0.03}) {
    all.push_back({std::sin(tilt), 0, std::cos(tilt)});
    all.push_back({0, std::sin(tilt), -std::cos(tilt)});
  }
  for (int i = 0; i < 12; ++i)
    all.push_back(normalize({std::sin(2.3 * i + 1), std::sin(4.1 * i), std::cos(7.7 * i)}));
  return all;
}

using Values = std::vector<double>;

// The largest error of each band over its scale; not finite becomes infinite.
void raiseErrors(const Values& values, const std::vector<Quad>& reference, std::vector<double>& errors) {
  const int degree = static_cast<int>(errors.size()) - 1;
  for (int l = 0; l <= degree; ++l)
    for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double error = std::abs(static_cast<double>(values[at] - reference[at])) / bandScale(l);
      errors[static_cast<std::size_t>(l)] =
          std::max(errors[static_cast<std::size_t>(l)], std::isfinite(error) ? error : HUGE_VAL);
    }
}

PlotCurve errorCurve(const std::string& name, const std::vector<double>& errors, bool dashed) {
  PlotCurve curve{name, {}, dashed};
  for (std::size_t l = 1; l < errors.size(); l += 1 + l / 24)
    curve.points.emplace_back(static_cast<double>(l), std::max(errors[l], 1e-17));
  return curve;
}

Values widened(const std::vector<float>& values) {
  return {values.begin(), values.end()};
}

Values batchFloat(int degree, Vec3d d) {
  const Vec3f u = toFloat(d);
  std::vector<float> values(static_cast<std::size_t>(coefficientCount(degree)));
  evaluateShBatch(degree, &u.x, &u.y, &u.z, 1, values.data(), 1);
  return widened(values);
}

double largest(const std::vector<double>& errors, std::size_t from, std::size_t to) {
  return *std::max_element(errors.begin() + static_cast<std::ptrdiff_t>(from),
                           errors.begin() + static_cast<std::ptrdiff_t>(to) + 1);
}

std::string overDegree(const Page& page) {
  const auto high = static_cast<std::size_t>(kHighest) + 1, low = static_cast<std::size_t>(kHighestFloat) + 1;
  std::vector<double> ours(high), stored(high), printed(200), oursFloat(low), printedFloat(low);
  for (const Vec3d& direction : directions()) {
    const std::vector<Quad> reference = referenceBasis(kHighest, direction);
    Values values(reference.size());
    evaluateSh(kHighest, direction, values);
    raiseErrors(values, reference, ours);
    raiseErrors(storedHeightBasis<double>(kHighest, direction.x, direction.y, direction.z), reference,
                stored);
    raiseErrors(unnormalisedBasis<double>(199, direction.x, direction.y, direction.z), reference, printed);
    const Vec3f u = toFloat(direction);
    const std::vector<Quad> rounded = referenceBasis(kHighestFloat, toDouble(u));
    raiseErrors(batchFloat(kHighestFloat, direction), rounded, oursFloat);
    raiseErrors(widened(unnormalisedBasis<float>(kHighestFloat, u.x, u.y, u.z)), rounded, printedFloat);
  }
  writePlot(page.pictures / "numerics_evaluation_degree.svg",
            {.title = "Evaluation: largest error of a band, in units of sqrt((2l+1)/4\u03c0)",
             .xLabel = "band l",
             .yLabel = "error",
             .curves = {errorCurve("shprt, double", ours, false),
                        errorCurve("shprt, float batch", oursFloat, false),
                        errorCurve("z as stored, double", stored, true),
                        errorCurve("unnormalised, double", printed, true),
                        errorCurve("unnormalised, float", printedFloat, true)},
             .yLow = 1e-17,
             .yHigh = 10});
  std::string text = fmt::format(
      "### Over degree\n\n![Error of evaluation over degree]({}numerics_evaluation_degree.svg)\n\n"
      "26 directions: axes, tilts of 1e-12 to 0.03 from the poles, and others. *Unnormalised* is the "
      "recurrence that Lisle\n"
      "and Huang print (as most textbooks do), normalised by factorials at the end; *z as stored* is the "
      "normalised\n"
      "recurrence of Holmes and Featherstone without care for the poles.\n\n{}",
      page.link, kPromiseHead);
  text += promiseRow("double, to band 100", largest(ours, 0, 100), 1e-13);
  text += promiseRow("double, to band 1000", largest(ours, 0, 1000), 1e-11);
  text += promiseRow("float batch, to band 8", largest(oursFloat, 0, 8), 1e-6);
  text += promiseRow("float batch, to band 32", largest(oursFloat, 0, 32), 1e-5);
  return text + "\n";
}

std::string overPoleDistance(const Page& page) {
  struct Line {
    int band;
    PlotCurve ours, stored;
  };
  std::vector<Line> lines;
  for (const int band : {100, 1000})
    lines.push_back({band,
                     {fmt::format("shprt, l = {}", band), {}, false},
                     {fmt::format("z as stored, l = {}", band), {}, true}});
  double worst = 0;
  for (double exponent = -20; exponent <= 0.001; exponent += 0.5) {
    const double tilt = std::pow(10.0, exponent);
    const Vec3d direction{std::sin(tilt) * 0.6, std::sin(tilt) * 0.8, std::cos(tilt)};
    const std::vector<Quad> reference = referenceBasis(kHighest, direction);
    Values values(reference.size());
    evaluateSh(kHighest, direction, values);
    std::vector<double> ours(static_cast<std::size_t>(kHighest) + 1), stored(ours.size());
    raiseErrors(values, reference, ours);
    raiseErrors(storedHeightBasis<double>(kHighest, direction.x, direction.y, direction.z), reference,
                stored);
    for (Line& line : lines) {
      const auto band = static_cast<std::size_t>(line.band);
      line.ours.points.emplace_back(tilt, std::max(ours[band], 1e-17));
      line.stored.points.emplace_back(tilt, std::max(stored[band], 1e-17));
      worst = std::max(worst, ours[band]);
    }
  }
  Plot plot{.title = "Evaluation beside the pole",
            .xLabel = "angle from the pole, radian",
            .yLabel = "error / sqrt((2l+1)/4\u03c0)",
            .curves = {},
            .yLow = 1e-17,
            .yHigh = 1e-9};
  for (const Line& line : lines) {
    plot.curves.push_back(line.ours);
    plot.curves.push_back(line.stored);
  }
  writePlot(page.pictures / "numerics_evaluation_pole.svg", plot);
  return fmt::format(
      "### Beside the poles\n\n![Error of evaluation beside the pole]({}numerics_evaluation_pole.svg)\n\n"
      "What z rounds away, x and y still hold. The worst error over all distances from 1e-20 to 1 radian, "
      "bands 100 and\n"
      "1000, is {:.1e}.\n\n",
      page.link, worst);
}

// Against central differences in quadruple precision along two tangents; what is left of them is far below
// double.
std::string gradients() {
  constexpr int kBand = 100;
  const Quad step = 1e-10;
  double worst = 0;
  for (const Vec3d direction : directions()) {
    const Vec3d side =
        normalize(cross(direction, std::abs(direction.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0}));
    std::vector<double> values(static_cast<std::size_t>(coefficientCount(kBand)));
    std::vector<Vec3d> slopes(values.size());
    evaluateShGradient(kBand, direction, values, slopes);
    for (const Vec3d tangent : {side, cross(side, direction)}) {
      const std::vector<Quad> ahead = referenceBasis(kBand, direction, tangent, step),
                              behind = referenceBasis(kBand, direction, tangent, -step);
      for (std::size_t i = 1; i < values.size(); ++i) {
        const int l = bandOf(static_cast<int>(i));
        const double error = std::abs(static_cast<double>(static_cast<Quad>(dot(slopes[i], tangent)) -
                                                          (ahead[i] - behind[i]) / (2 * step)));
        worst = std::max(worst, error / (l * bandScale(l)));
      }
    }
  }
  return fmt::format("### Gradients\n\nIn units of l sqrt((2l+1)/4\u03c0), poles included.\n\n{}{}\n",
                     kPromiseHead, promiseRow("gradient in double, to band 100", worst, 1e-13));
}

}  // namespace

std::string evaluationSection(const Page& page) {
  return "## Evaluation\n\n" + overDegree(page) + overPoleDistance(page) + gradients();
}

}  // namespace shprt::numerics
