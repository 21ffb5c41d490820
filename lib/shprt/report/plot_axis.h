// The range of an axis and where it has labels. Internal to the room.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shprt {

struct PlotAxis {
  bool logarithmic = true;
  double low = 1, high = 10;                         // low < high; positive where logarithmic
  std::vector<std::pair<double, std::string>> tics;  // values and their labels, rising

  // The value as it can be drawn: on an edge where it lies beyond, or has no logarithm. NaN stays NaN.
  double place(double value) const;
};

// A range around the values that can be drawn: of whole decades, or of 1-2-5 steps where they span few. `low`
// and `high` are edges that are asked for.
PlotAxis chooseAxis(const std::vector<double>& values, bool logarithmic, std::optional<double> low = {},
                    std::optional<double> high = {});

}  // namespace shprt
