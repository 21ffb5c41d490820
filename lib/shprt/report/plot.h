// Line plots as SVG: what a table of errors and times looks like.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace shprt {

struct PlotCurve {
  std::string name;                               // in the legend
  std::vector<std::pair<double, double>> points;  // x, y, in the order in which they are joined
  bool dashed = false;                            // for what is only compared with
};

// Both axes are logarithmic: errors and costs span decades.
struct Plot {
  std::string title, xLabel, yLabel;
  std::vector<PlotCurve> curves;
  double yLow = 0, yHigh = 0;  // powers of ten that the y axis is cut at; 0: as the points ask
};

// Points that are not finite, or not positive where they have no logarithm, stand on the upper and the lower
// edge. The picture needs no fonts or scripts, and looks right on a light and on a dark page. Equal plots
// give equal bytes.
std::string formatSvg(const Plot& plot);

// Throws Error when the file cannot be written.
void writePlot(const std::filesystem::path& path, const Plot& plot);

}  // namespace shprt
