// Zonal factors: circular windows of all sizes, the clamped cosine.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bench/numerics/peers.h"
#include "bench/numerics/quad.h"
#include "bench/numerics/sections.h"
#include "shprt/report/gnuplot.h"
#include "shprt/sh/circular_window.h"
#include "shprt/sh/zonal.h"

namespace shprt::numerics {
namespace {

constexpr int kHighest = 1000;
constexpr double kFloor = 1e-18;

// Errors relative to cos^2(zeta / 2), the size that the factors have before they fall off.
template <typename Real>
PlotCurve windowCurve(const std::string& name, const std::vector<Real>& factors, double zeta, bool dashed,
                      double& worst) {
  const std::vector<Quad> reference = referenceWindow(kHighest, static_cast<Quad>(static_cast<Real>(zeta)));
  const double scale = std::cos(zeta / 2) * std::cos(zeta / 2);
  PlotCurve curve{name, {}, dashed};
  worst = 0;
  std::size_t next = 1;
  for (std::size_t l = 1; l < factors.size(); ++l) {
    const double error = std::abs(static_cast<double>(factors[l] - reference[l])) / scale;
    worst = std::max(worst, std::isfinite(error) ? error : HUGE_VAL);
    if (l < next) continue;
    curve.points.emplace_back(static_cast<double>(l), plottedError(error, kFloor));
    next = l + 1 + l / 24;
  }
  return curve;
}

std::string windows(const Page& page) {
  Plot plot{.title = "Circular windows: error of the band factors",
            .xLabel = "band l",
            .yLabel = "error / cos\u00b2(\u03b6/2)",
            .curves = {},
            .yLow = kFloor,
            .yHigh = 10};
  std::string table = "| radius \u03b6 | shprt | printed, double | printed, float |\n|---|---|---|---|\n";
  double worst = 0;
  for (const double zeta : {1e-8, 1e-5, 1e-3, 0.03, 0.5, 1.5, 3.0, 3.14}) {
    double ours = 0, printed = 0, printedFloat = 0;
    const PlotCurve oursCurve = windowCurve(fmt::format("shprt, {:g} rad", zeta),
                                            circularWindowFactors(kHighest, zeta), zeta, false, ours);
    const PlotCurve printedCurve = windowCurve(fmt::format("printed, {:g} rad", zeta),
                                               printedWindow<double>(kHighest, zeta), zeta, true, printed);
    const PlotCurve floatCurve =
        windowCurve(fmt::format("float, {:g} rad", zeta),
                    printedWindow<float>(kHighest, static_cast<float>(zeta)), zeta, true, printedFloat);
    if (zeta == 1e-8 || zeta == 0.03 || zeta == 3.0) {
      plot.curves.push_back(oursCurve);
      plot.curves.push_back(printedCurve);
    }
    if (zeta == 0.03) plot.curves.push_back(floatCurve);
    table += fmt::format("| {:g} | {:.1e} | {:.1e} | {:.1e} |\n", zeta, ours, printed, printedFloat);
    worst = std::max(worst, ours);
  }
  writePlot(page.pictures / "numerics_window.svg", plot);
  return fmt::format(
      "### Circular windows\n\n![Error of circular windows]({}numerics_window.svg)\n\n"
      "A sun of half a degree has \u03b6 = 0.0047. *Printed* is Lisle and Huang's recurrence, eq. 11, as it "
      "stands. Worst error of\n"
      "bands 1 to 1000:\n\n{}\n{}{}\n",
      page.link, table, kPromiseHead,
      promiseRow("windows of 1e-8 rad to the whole sphere, to band 1000", worst, 2e-15));
}

// A_l = 2 pi times the integral of t P_l(t), l >= 2 even: closed form by a ratio, in quadruple precision.
std::string clampedCosine() {
  const std::vector<double> factors = clampedCosineFactors(kHighest);
  const Quad pi = quadPi();
  std::vector<Quad> reference(factors.size());
  reference[0] = pi;
  reference[1] = 2 * pi / 3;
  // A_l / A_{l-2} = -(l - 3) / (l + 2) for even l >= 4, A_2 = pi / 4.
  reference[2] = pi / 4;
  for (std::size_t l = 4; l < reference.size(); l += 2)
    reference[l] = -reference[l - 2] * static_cast<Quad>(static_cast<int>(l) - 3) /
                   static_cast<Quad>(static_cast<int>(l) + 2);
  double worst = 0;
  for (std::size_t l = 0; l < factors.size(); ++l) {
    const double size = static_cast<double>(reference[l] < 0 ? -reference[l] : reference[l]);
    const double error = std::abs(static_cast<double>(factors[l] - reference[l]));
    worst = std::max(worst, size > 0 ? error / size : error);
  }
  return std::string("### Clamped cosine\n\n") + kPromiseHead +
         promiseRow("relative error of A_l, to band 1000", worst, 1e-13) + "\n";
}

}  // namespace

std::string zonalSection(const Page& page) {
  return "## Zonal functions\n\n" + windows(page) + clampedCosine();
}

}  // namespace shprt::numerics
