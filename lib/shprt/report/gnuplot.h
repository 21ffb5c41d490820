// Line plots as SVG, drawn by gnuplot.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shprt {

struct PlotCurve {
  std::string name;                               // in the legend
  std::vector<std::pair<double, double>> points;  // x, y, in the order in which they are joined
  bool dashed = false;                            // for what is only compared with
  // Fitted in log-log: y ~ x^slope. In the legend, and as a line through the points' middle.
  std::optional<double> slope{};
};

// Texts are plain text, of any characters.
struct Plot {
  std::string title, xLabel, yLabel;
  bool logX = true, logY = true;
  std::vector<PlotCurve> curves;
  std::optional<double> yLow{}, yHigh{};  // where the y axis is cut; else as the points ask
  bool titleInside = true;                // else it is only told to those who do not see the picture
};

struct Gnuplot {
  std::string program = "gnuplot";          // found as a shell would find it
  std::chrono::milliseconds limit{20'000};  // for one plot
};

struct Drawing {
  std::string svg;      // one <svg> element; "" where it could not be drawn
  std::string missing;  // why not, and what to do about it, in one line; "" where it was
};

// Points that are infinite, or not positive where they have no logarithm, stand on the edge that they are
// beyond; NaN leaves a gap. The picture scales with its page, looks right on a light and on a dark one, and
// holds no scripts and no references to other files. All its element ids begin with `name` (letters, digits,
// '-' and '_', a letter first), so that several pictures can stand in one page. Equal plots give equal bytes
// for one version of gnuplot.
Drawing drawPlot(const Plot& plot, const std::string& name, const Gnuplot& gnuplot = {});

// Throws Error when the plot cannot be drawn or the file cannot be written.
void writePlot(const std::filesystem::path& path, const Plot& plot, const Gnuplot& gnuplot = {});

}  // namespace shprt
