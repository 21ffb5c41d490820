// Plots: points land where the axes say, whatever the values are.
#include "shprt/report/plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace shprt {
namespace {

// The coordinates of the nth curve's path.
std::vector<std::pair<double, double>> coordinates(const std::string& svg, int curve) {
  std::size_t at = 0;
  for (int i = 0; i <= 2 * curve; ++i) at = svg.find("<path d=\"M", at) + 10;
  std::string path = svg.substr(at, svg.find('"', at) - at);
  for (char& c : path) c = c == 'L' ? ' ' : c;
  std::istringstream in(path);
  std::vector<std::pair<double, double>> points;
  for (double x = 0, y = 0; in >> x >> y;) points.emplace_back(x, y);
  return points;
}

TEST(Plot, DecadesAreEvenlySpaced) {
  const auto points = coordinates(formatSvg({.title = "t",
                                             .xLabel = "x",
                                             .yLabel = "y",
                                             .curves = {{"c", {{1, 1e-3}, {10, 1e-2}, {100, 1e-1}}}}}),
                                  0);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_NEAR(points[1].first - points[0].first, points[2].first - points[1].first, 0.11);
  EXPECT_NEAR(points[1].second - points[0].second, points[2].second - points[1].second, 0.11);
  EXPECT_GT(points[1].first, points[0].first);
  EXPECT_LT(points[1].second, points[0].second);  // up is less in SVG
}

TEST(Plot, WhatHasNoPlaceStandsOnAnEdge) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto points =
      coordinates(formatSvg({.title = "t",
                             .xLabel = "x",
                             .yLabel = "y",
                             .curves = {{"c", {{1, 1e-3}, {2, 1}, {3, infinity}, {4, NAN}, {5, 0}}}}}),
                  0);
  ASSERT_EQ(points.size(), 5u);
  EXPECT_EQ(points[2].second, points[1].second);
  EXPECT_EQ(points[3].second, points[1].second);
  EXPECT_EQ(points[4].second, points[0].second);
}

TEST(Plot, IsWholeWhateverItIsGiven) {
  for (const std::vector<PlotCurve>& curves : {std::vector<PlotCurve>{},
                                               {{"empty", {}}},
                                               {{"zero", {{0, 0}}}},
                                               {{"one <&> point", {{3, 3}}, true}}}) {
    const std::string svg = formatSvg({.title = "a < b", .xLabel = "", .yLabel = "", .curves = curves});
    EXPECT_TRUE(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
    EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
  }
}

}  // namespace
}  // namespace shprt
