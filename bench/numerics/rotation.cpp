// Rotation: error and orthogonality over degree, at hard rotations, and over the tilt of the axis.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bench/numerics/quad.h"
#include "bench/numerics/sections.h"
#include "shprt/report/gnuplot.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"
#include "tests/sh/peer_rotation.h"

namespace shprt::numerics {
namespace {

constexpr double kFloor = 1e-17;
constexpr int kHighest = 200, kHighestPeer = 100;

using Matrix = std::vector<double>;

double largestDifference(const Matrix& matrix, const std::vector<Quad>& reference) {
  double worst = 0;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    const double error = std::abs(static_cast<double>(matrix[i] - reference[i]));
    worst = std::max(worst, std::isfinite(error) ? error : HUGE_VAL);
  }
  return worst;
}

// The largest entry of D D^T - 1.
double orthogonalityDefect(const Matrix& matrix, int l) {
  const auto size = static_cast<std::size_t>(2 * l + 1);
  double worst = 0;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < size; ++k) sum += matrix[i * size + k] * matrix[j * size + k];
      worst = std::max(worst, std::abs(sum - (i == j ? 1 : 0)));
    }
  return std::isfinite(worst) ? worst : HUGE_VAL;
}

std::vector<std::pair<std::string, Mat3>> hardRotations() {
  std::vector<std::pair<std::string, Mat3>> rotations;
  for (const auto& [name, specification] : {std::pair{"identity", "axis:0,0,1,0"},
                                            {"half turn about x", "axis:1,0,0,180"},
                                            {"half turn about y", "axis:0,1,0,180"},
                                            {"half turn about z", "axis:0,0,1,180"},
                                            {"half turn about (1,1,0)", "axis:1,1,0,180"},
                                            {"quarter turn about x", "axis:1,0,0,90"},
                                            {"third about (1,1,1)", "axis:1,1,1,120"},
                                            {"beta exactly 0", "euler:zyz,20,0,30"},
                                            {"beta exactly 180 degrees", "euler:zyz,20,180,30"},
                                            {"beta 1e-12 rad", "euler:zyz,20,5.729577951308232e-11,30"},
                                            {"beta 1e-8 rad", "euler:zyz,20,5.729577951308232e-7,30"},
                                            {"beta 0.1 rad", "euler:zyz,10,5.729577951308232,200"},
                                            {"beta 3.0 rad", "euler:zyz,10,171.88733853924697,-20"},
                                            {"general", "axis:-1,2,0.5,77"}})
    rotations.emplace_back(name, parseRotation(specification));
  return rotations;
}

// The largest error of a coefficient that rotateMany turns in float, over the norm of its band.
double manyError(int degree) {
  const auto count = static_cast<std::size_t>(coefficientCount(degree));
  double worst = 0;
  for (const auto& [name, matrix] : hardRotations()) {
    std::vector<float> from(count), to(count);
    std::vector<double> exact(count);
    for (std::size_t i = 0; i < count; ++i) {
      from[i] = static_cast<float>(std::sin(1.7 * static_cast<double>(i) + 0.4));
      exact[i] = static_cast<double>(from[i]);
    }
    const ShRotation rotation(degree, matrix);
    rotateMany(rotation, from.data(), to.data(), 1, 1);
    rotation.apply(exact);
    for (int l = 0; l <= degree; ++l) {
      double error = 0, norm = 0;
      for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i) {
        const auto at = static_cast<std::size_t>(i);
        error = std::max(error, std::abs(static_cast<double>(to[at]) - exact[at]));
        norm += exact[at] * exact[at];
      }
      worst = std::max(worst, error / std::sqrt(norm));
    }
  }
  return worst;
}

std::string atHardRotations() {
  std::string table =
      "| rotation | error, l = 50 | defect, l = 50 | error, l = 200 | defect, l = 200 "
      "|\n|---|---|---|---|---|\n";
  double worst50 = 0, worst200 = 0;
  for (const auto& [name, rotation] : hardRotations()) {
    const auto [alpha, beta, gamma] = referenceAngles(rotation);
    ReferenceWigner wigner(beta);
    table += "| " + name + " |";
    while (wigner.band() < kHighest) {
      wigner.climb();
      const int l = wigner.band();
      if (l != 50 && l != kHighest) continue;
      const Matrix ours = wignerMatrix(l, rotation);
      const double error = largestDifference(ours, referenceRotation(wigner, alpha, gamma)),
                   defect = orthogonalityDefect(ours, l);
      table += fmt::format(" {:.1e} | {:.1e} |", error, defect);
      double& worst = l == 50 ? worst50 : worst200;
      worst = std::max({worst, error, defect});
    }
    table += "\n";
  }
  return "### Hard rotations\n\nLargest error of an entry of the Wigner matrix, and of D D^T - 1.\n\n" +
         table + "\n" + kPromiseHead + promiseRow("error and defect at l = 50", worst50, 2e-14) +
         promiseRow("error and defect at l = 200", worst200, 5e-14) +
         promiseRow("many sets in float, to band 8, over a band's norm", manyError(8), 1e-6) +
         promiseRow("many sets in float, to band 32, over a band's norm", manyError(32), 1e-5) + "\n";
}

Mat3 turnAboutY(double beta) {
  return rotationFromEulerZyz(0, beta, 0);
}

struct Contest {
  PlotCurve ours{"shprt", {}, false}, direct{"Ivanic-Ruedenberg, Choi", {}, true},
      recurrence{"Lisle and Huang", {}, true};

  // Errors at band l of the turn by beta about y, for which wigner stands ready.
  void add(double x, int l, double beta, const ReferenceWigner& wigner) {
    const std::vector<Quad> reference = referenceRotation(wigner, 0, 0);
    const auto addTo = [&](PlotCurve& curve, const Matrix& matrix) {
      curve.points.emplace_back(x, plottedError(largestDifference(matrix, reference), kFloor));
    };
    addTo(ours, wignerMatrix(l, turnAboutY(beta)));
    if (l > kHighestPeer) return;
    addTo(direct, test::ivanicRuedenbergWigner(l, turnAboutY(beta)));
    addTo(recurrence, test::realRecurrenceTurnAboutY(l, beta));
  }
  std::vector<PlotCurve> curves() const { return {ours, direct, recurrence}; }
};

std::string overDegree(const Page& page) {
  constexpr double kBeta = 1.3;
  ReferenceWigner wigner(referenceAngles(turnAboutY(kBeta)).beta);
  Contest contest;
  while (wigner.band() < kHighest) {
    wigner.climb();
    const int l = wigner.band();
    if (l <= 10 || l % 10 == 0) contest.add(l, l, kBeta, wigner);
  }
  writePlot(page.pictures / "numerics_rotation_degree.svg",
            {.title = "Rotation by 1.3 rad about y: largest error of an entry of D",
             .xLabel = "band l",
             .yLabel = "error",
             .curves = contest.curves(),
             .yLow = kFloor,
             .yHigh = 10});
  return fmt::format(
      "### Over degree\n\n![Error of rotation over degree]({}numerics_rotation_degree.svg)\n\n"
      "shprt turns about z between two fixed exchanges of axes, band by band; the direct recursion and the "
      "recurrence\n"
      "across bands (with the misprint in its interior mended) amplify their rounding at every band.\n\n",
      page.link);
}

std::string overTilt(const Page& page) {
  constexpr int kBand = 50;
  Contest contest;
  for (double exponent = -12; exponent <= 0.51; exponent += 0.5) {
    const double tilt = std::min(std::pow(10.0, exponent), 3.1);
    ReferenceWigner wigner(referenceAngles(turnAboutY(tilt)).beta);
    while (wigner.band() < kBand) wigner.climb();
    contest.add(tilt, kBand, tilt, wigner);
  }
  writePlot(page.pictures / "numerics_rotation_tilt.svg",
            {.title = "Rotation at l = 50 over the tilt of the z axis",
             .xLabel = "tilt \u03b2, radian",
             .yLabel = "error of an entry",
             .curves = contest.curves(),
             .yLow = kFloor,
             .yHigh = 10});
  return fmt::format(
      "### Over tilt\n\n![Error of rotation over tilt]({}numerics_rotation_tilt.svg)\n\n"
      "The direct recursion is as good as ours at small tilts and loses digits at large ones; the recurrence "
      "across bands\n"
      "hides its errors at tilts near 0.\n\n",
      page.link);
}

}  // namespace

std::string rotationSection(const Page& page) {
  return "## Rotation\n\n" + overDegree(page) + atHardRotations() + overTilt(page);
}

}  // namespace shprt::numerics
