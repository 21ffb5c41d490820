#include "shprt/report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "shprt/base/file.h"

namespace shprt {
namespace {

constexpr double kWidth = 760, kHeight = 440;
constexpr double kLeft = 78, kRight = 220, kTop = 44, kBottom = 56;
constexpr double kPlotWidth = kWidth - kLeft - kRight, kPlotHeight = kHeight - kTop - kBottom;

// Told apart by people who see colours differently, too. Based on: Wong 2011.
constexpr std::array<const char*, 7> kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                 "#e69f00", "#56b4e9", "#555555"};

// One axis in decades: exponents low to high become 0 to 1.
struct Axis {
  int low = 0, high = 1;

  double at(double value) const {
    if (!(value > 0)) return std::isnan(value) ? 1 : 0;
    return std::clamp((std::log10(value) - low) / (high - low), 0.0, 1.0);
  }
  // Every so many decades there is room for a label.
  int step(int labels) const { return std::max(1, (high - low + labels - 1) / labels); }
};

template <typename ValueOf>
Axis chooseAxis(const Plot& plot, const ValueOf& valueOf) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const PlotCurve& curve : plot.curves)
    for (const auto& point : curve.points) {
      const double value = valueOf(point);
      if (!(value > 0) || !std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  if (!(high > 0)) return {};
  Axis axis{static_cast<int>(std::floor(std::log10(low) + 1e-9)),
            static_cast<int>(std::ceil(std::log10(high) - 1e-9))};
  axis.high = std::max(axis.high, axis.low + 1);
  return axis;
}

std::string escape(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '&')
      escaped += "&amp;";
    else
      escaped += c;
  }
  return escaped;
}

std::string label(double x, double y, const std::string& anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escape(text));
}

std::string powerOfTen(double x, double y, const std::string& anchor, int exponent) {
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">10<tspan dy=\"-5\" "
      "font-size=\"9\">{}</tspan></text>\n",
      x, y, anchor, exponent);
}

std::string gridLine(double x1, double y1, double x2, double y2) {
  return fmt::format("<line class=\"grid\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", x1,
                     y1, x2, y2);
}

std::string drawAxes(const Plot& plot, const Axis& x, const Axis& y) {
  constexpr int kLabels = 9;
  std::string svg;
  for (int e = x.low; e <= x.high; e += x.step(kLabels)) {
    const double at = kLeft + kPlotWidth * (e - x.low) / (x.high - x.low);
    svg += gridLine(at, kTop, at, kTop + kPlotHeight);
    svg += powerOfTen(at, kTop + kPlotHeight + 20, "middle", e);
  }
  for (int e = y.low; e <= y.high; e += y.step(kLabels)) {
    const double at = kTop + kPlotHeight * (1 - static_cast<double>(e - y.low) / (y.high - y.low));
    svg += gridLine(kLeft, at, kLeft + kPlotWidth, at);
    svg += powerOfTen(kLeft - 8, at + 4, "end", e);
  }
  svg += label(kLeft + kPlotWidth / 2, kHeight - 12, "middle", plot.xLabel);
  svg +=
      fmt::format("<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                  kTop + kPlotHeight / 2, escape(plot.yLabel));
  return svg;
}

std::string drawCurve(const PlotCurve& curve, const Axis& x, const Axis& y, std::size_t number) {
  const char* colour = kColours[number % kColours.size()];
  std::string path;
  for (const auto& [valueX, valueY] : curve.points) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : " L", kLeft + kPlotWidth * x.at(valueX),
                        kTop + kPlotHeight * (1 - y.at(valueY)));
  }
  const std::string style = fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}", colour,
                                        curve.dashed ? " stroke-dasharray=\"6 4\"" : "");
  const double legendX = kLeft + kPlotWidth + 14, legendY = kTop + 10 + 22 * static_cast<double>(number);
  std::string svg = path.empty() ? "" : fmt::format("<path d=\"{}\" {}/>\n", path, style);
  svg += fmt::format("<path d=\"M{:.1f} {:.1f} h26\" {}/>\n", legendX, legendY, style);
  svg += label(legendX + 32, legendY + 4, "start", curve.name);
  return svg;
}

}  // namespace

std::string formatSvg(const Plot& plot) {
  const Axis x = chooseAxis(plot, [](const auto& point) { return point.first; });
  Axis y = chooseAxis(plot, [](const auto& point) { return point.second; });
  if (plot.yLow > 0) y.low = static_cast<int>(std::lround(std::log10(plot.yLow)));
  if (plot.yHigh > 0) y.high = static_cast<int>(std::lround(std::log10(plot.yHigh)));
  y.high = std::max(y.high, y.low + 1);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n"
      "<style>.grid{{stroke:#8884;stroke-width:1}}text{{fill:#222}}.back{{fill:#fff}}"
      "@media(prefers-color-scheme:dark){{text{{fill:#ddd}}.back{{fill:#181818}}}}</style>\n"
      "<rect class=\"back\" width=\"{0}\" height=\"{1}\"/>\n",
      kWidth, kHeight);
  svg += fmt::format("<text x=\"{:.1f}\" y=\"26\" font-size=\"15\" text-anchor=\"start\">{}</text>\n", kLeft,
                     escape(plot.title));
  svg += drawAxes(plot, x, y);
  for (std::size_t i = 0; i < plot.curves.size(); ++i) svg += drawCurve(plot.curves[i], x, y, i);
  return svg + "</svg>\n";
}

void writePlot(const std::filesystem::path& path, const Plot& plot) {
  writeFile(path, formatSvg(plot));
}

}  // namespace shprt
