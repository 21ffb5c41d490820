// gnuplot gets its commands and all points on standard input and returns the picture on standard output. What
// its svg terminal leaves to be desired (ids that all plots share, black ink on dark pages, no description)
// is put right in the text that it returns.
#include "shprt/report/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/report/child_process.h"
#include "shprt/report/markup.h"
#include "shprt/report/plot_axis.h"

namespace shprt {
namespace {

// Told apart by people who see colours differently, too, and legible on white and on near-black.
// Based on: Wong 2011, with a grey for the last.
constexpr std::array<const char*, 7> kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                 "#e69f00", "#56b4e9", "#888888"};

constexpr int kWidth = 760, kPlotHeight = 400, kLegendRowHeight = 19;

// Each point has its mark, but where they would run into each other.
constexpr std::size_t kMostMarks = 40;
constexpr const char* kMarkedLines = "linespoints pointtype 7 pointsize 0.4";

// In single quotes gnuplot takes everything as it stands, but the quote itself.
std::string quote(const std::string& text) {
  std::string quoted = "'";
  for (const char c : plainLine(text)) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

std::string axisCommands(char axis, const PlotAxis& range, const std::string& label) {
  std::string tics;
  for (const auto& [value, text] : range.tics)
    tics += fmt::format("{}{} {}", tics.empty() ? "" : ", ", quote(text), value);
  return fmt::format("{0}set {1}range [{2}:{3}]\nset {1}tics ({4}) nomirror\nset {1}label {5} noenhanced\n",
                     range.logarithmic ? fmt::format("set logscale {}\n", axis) : "", axis, range.low,
                     range.high, tics, quote(label));
}

// A coordinate as gnuplot reads it: NaN leaves a gap.
std::string coordinate(double value) {
  return std::isnan(value) ? "NaN" : fmt::format("{}", value);
}

std::string block(const std::string& name, const std::vector<std::pair<double, double>>& points) {
  std::string text = fmt::format("${} << EndOfPoints\n", name);
  for (const auto& [x, y] : points) text += coordinate(x) + " " + coordinate(y) + "\n";
  return text + "EndOfPoints\n";
}

// The ends of the fitted line: through the mean of the logarithms, as least squares have it. Nothing where
// the fit has nothing to rest on, or would be no straight line.
std::vector<std::pair<double, double>> fittedLine(const Plot& plot, const PlotCurve& curve) {
  if (!curve.slope || !std::isfinite(*curve.slope) || !plot.logX || !plot.logY) return {};
  double count = 0, sumX = 0, sumY = 0, least = INFINITY, greatest = 0;
  for (const auto& [x, y] : curve.points) {
    if (!(x > 0 && y > 0 && std::isfinite(x) && std::isfinite(y))) continue;
    ++count, sumX += std::log(x), sumY += std::log(y);
    least = std::min(least, x), greatest = std::max(greatest, x);
  }
  if (count < 2) return {};
  const auto at = [&](double x) {
    return std::pair(x, std::exp(sumY / count + *curve.slope * (std::log(x) - sumX / count)));
  };
  return {at(least), at(greatest)};
}

std::string legend(const PlotCurve& curve) {
  return curve.slope ? fmt::format("{} (slope {:.2f})", curve.name, *curve.slope) : curve.name;
}

std::string script(const Plot& plot, const std::string& name) {
  std::vector<double> xs, ys;
  for (const PlotCurve& curve : plot.curves)
    for (const auto& [x, y] : curve.points) xs.push_back(x), ys.push_back(y);
  const PlotAxis x = chooseAxis(xs, plot.logX), y = chooseAxis(ys, plot.logY, plot.yLow, plot.yHigh);
  std::string commands = fmt::format(
      "set terminal svg size {},{} dynamic enhanced font 'sans-serif,13' name '{}' background '#ffffff'\n"
      "set encoding utf8\nset title {} noenhanced\nset grid linetype 1 linecolor rgb 'gray' linewidth 0.5\n"
      "set border 3\nset key outside bottom center vertical maxcols 1 reverse Left height 1 noenhanced\n",
      kWidth, kPlotHeight + kLegendRowHeight * static_cast<int>(plot.curves.size()), name,
      quote(plot.titleInside ? plot.title : ""));
  commands += axisCommands('x', x, plot.xLabel) + axisCommands('y', y, plot.yLabel);
  std::string drawn;
  const auto draw = [&](const std::string& what, const std::string& style, const std::string& title) {
    drawn += fmt::format("{}${} using 1:2 with {} {}", drawn.empty() ? "plot " : ", ", what, style, title);
  };
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const PlotCurve& curve = plot.curves[i];
    const std::string colour = fmt::format("linecolor rgb '{}'", kColours[i % kColours.size()]);
    std::vector<std::pair<double, double>> placed;
    for (const auto& point : curve.points) placed.emplace_back(x.place(point.first), y.place(point.second));
    // A curve without points has its place in the legend.
    if (placed.empty()) placed.emplace_back(NAN, NAN);
    const std::string points = fmt::format("curve{}", i);
    commands += block(points, placed);
    draw(points,
         fmt::format("{} {} linewidth 2 {}", placed.size() > kMostMarks ? "lines" : kMarkedLines, colour,
                     curve.dashed ? "dashtype (10,6)" : "dashtype 1"),
         "title " + quote(legend(curve)));
    if (const auto line = fittedLine(plot, curve); !line.empty()) {
      commands += block(fmt::format("fit{}", i), line);
      draw(fmt::format("fit{}", i), fmt::format("lines {} linewidth 1 dashtype (2,4)", colour), "notitle");
    }
  }
  // gnuplot draws nothing for no curves; axes there are to be even then.
  if (drawn.empty()) drawn = "plot NaN notitle";
  return commands + drawn + "\n";
}

// Puts `name` before all ids of the picture and before what refers to them. Outside of tags is text that may
// look alike.
std::string withOwnIds(std::string_view svg, const std::string& name) {
  constexpr std::array<std::string_view, 6> kBefore = {" id='",    " id=\"", "href='#",
                                                       "href=\"#", "url(#",  "url('#"};
  std::string result;
  bool inTag = false;
  for (std::size_t at = 0; at < svg.size();) {
    const std::string_view rest = svg.substr(at);
    const auto found = std::find_if(kBefore.begin(), kBefore.end(),
                                    [&](std::string_view before) { return rest.starts_with(before); });
    if (inTag && found != kBefore.end()) {
      result += *found;
      result += name + "-";
      at += found->size();
      continue;
    }
    if (rest.front() == '<' || rest.front() == '>') inTag = rest.front() == '<';
    result += rest.front();
    ++at;
  }
  return result;
}

// The ink that gnuplot draws axes and text with turns light on dark pages, the ground dark.
constexpr std::string_view kStyle =
    "<style>.shprt-plot{max-width:100%;height:auto}"
    "@media(prefers-color-scheme:dark){.shprt-plot [fill=black]{fill:#ddd}.shprt-plot "
    "[stroke=black]{stroke:#ddd}.shprt-plot [color=black]{color:#ddd}.shprt-plot "
    ".gridline{stroke:#484848}.shprt-plot [fill='#ffffff']{fill:#181818}}"
    "@media print{.shprt-plot{break-inside:avoid}}</style>";

// "" when this is no picture.
std::string finish(const std::string& output, const Plot& plot, const std::string& name) {
  const std::size_t begin = output.find("<svg"), end = output.rfind("</svg>");
  const std::size_t titleBegin = output.find("<title>"), titleEnd = output.find("</title>");
  if (begin == std::string::npos || end == std::string::npos || titleBegin == std::string::npos ||
      titleEnd == std::string::npos || !(begin < titleBegin && titleBegin < titleEnd && titleEnd < end))
    return "";
  const std::string title = escapeMarkup(plot.title);
  const std::string svg = "<svg class=\"shprt-plot\" role=\"img\" aria-label=\"" + title + "\"" +
                          output.substr(begin + 4, titleBegin - begin - 4) + "<title>" + title +
                          "</title>\n" + std::string(kStyle) +
                          output.substr(titleEnd + 8, end - titleEnd - 8) + "</svg>\n";
  return withOwnIds(svg, name);
}

std::string firstLine(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    // gnuplot repeats the line at fault and marks the place; what is wrong comes after them.
    const std::string line = text.substr(at, end - at);
    if (line.find("line ") != std::string::npos && line.find("warning") == std::string::npos) return line;
    at = end + 1;
  }
  return "";
}

}  // namespace

Drawing drawPlot(const Plot& plot, const std::string& name, const Gnuplot& gnuplot) {
  // -d: not with what a user has set up for plots of their own.
  const ChildResult result = runChild({gnuplot.program, "-d"}, script(plot, name), gnuplot.limit);
  if (!result.found)
    return {"", "no plots: there is no program " + plainLine(gnuplot.program) +
                    "; install it with: apt-get install gnuplot-nox"};
  if (!result.failure.empty()) {
    const std::string complaint = plainLine(firstLine(result.errors));
    return {"", "no plots: " + plainLine(gnuplot.program) + " " + result.failure +
                    (complaint.empty() ? "" : " (" + complaint + ")") + "; check that it draws SVG"};
  }
  const std::string svg = finish(result.output, plot, name);
  if (svg.empty())
    return {"", "no plots: " + plainLine(gnuplot.program) + " returned no picture; check that it draws SVG"};
  return {svg, ""};
}

void writePlot(const std::filesystem::path& path, const Plot& plot, const Gnuplot& gnuplot) {
  const Drawing drawing = drawPlot(plot, "plot", gnuplot);
  if (drawing.svg.empty()) throw Error(path.string(), drawing.missing);
  writeFile(path, drawing.svg);
}

}  // namespace shprt
