#include "shprt/study/study_page.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string_view>
#include <system_error>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/report/markup.h"
#include "shprt/study/study_json.h"
#include "shprt/study/study_page_style.h"

namespace shprt {
namespace {

std::string element(std::string_view tag, std::string_view content, std::string_view attributes = "") {
  return fmt::format("<{0}{1}{2}>{3}</{0}>\n", tag, attributes.empty() ? "" : " ", attributes, content);
}

std::string number(double value) {
  if (std::isnan(value)) return "\u2013";
  if (std::isinf(value)) return value > 0 ? "\u221e" : "\u2212\u221e";
  return fmt::format("{:.4g}", value);
}

bool looksNumeric(std::string_view cell) {
  if (!cell.empty() && (cell.front() == '-' || cell.front() == '+')) cell.remove_prefix(1);
  return !cell.empty() && cell.front() >= '0' && cell.front() <= '9';
}

std::string tableCell(const std::string& cell) {
  if (cell.starts_with("shprt ")) return "<td><code>" + escapeMarkup(cell) + "</code></td>";
  return (looksNumeric(cell) ? "<td class=\"number\">" : "<td>") + escapeMarkup(cell) + "</td>";
}

// Wide tables scroll by themselves, and by keyboard, too.
std::string formatTable(const StudyTable& table) {
  std::string head, rows;
  for (const std::string& column : table.columns)
    head += "<th scope=\"col\">" + escapeMarkup(column) + "</th>";
  for (const std::vector<std::string>& row : table.rows) {
    std::string cells;
    for (const std::string& cell : row) cells += tableCell(cell);
    rows += element("tr", cells);
  }
  const std::string caption = table.title.empty() ? "" : element("caption", escapeMarkup(table.title));
  return "<div class=\"scroll\" tabindex=\"0\">\n" +
         element("table", "\n" + caption + (head.empty() ? "" : element("thead", element("tr", head))) +
                              element("tbody", "\n" + rows)) +
         "</div>\n";
}

StudyTable pointsOf(const StudyChart& chart) {
  StudyTable table{chart.id, "", {"curve", chart.xLabel, chart.yLabel}, {}};
  for (const StudyCurve& curve : chart.curves)
    for (const auto& [x, y] : curve.points) table.rows.push_back({curve.name, number(x), number(y)});
  return table;
}

StudyTable figuresOf(const StudySection& section) {
  StudyTable table{section.id, "", {"figure", "value"}, {}};
  for (const auto& [name, value] : section.figures) table.rows.push_back({name, number(value)});
  return table;
}

std::string slopesOf(const StudyChart& chart) {
  std::string slopes;
  for (const StudyCurve& curve : chart.curves)
    if (curve.slope)
      slopes +=
          fmt::format("{}{} {:.2f}", slopes.empty() ? "Fitted slopes: " : "; ", curve.name, *curve.slope);
  return slopes.empty() ? "" : element("p", escapeMarkup(slopes + "."));
}

std::string formatChart(const StudyChart& chart, const std::string& svg) {
  const std::string points = slopesOf(chart) + formatTable(pointsOf(chart));
  const std::string caption = element("figcaption", escapeMarkup(chart.title));
  if (svg.empty()) return element("figure", "\n" + caption + points);
  return element("figure",
                 "\n" + caption + svg + element("details", "<summary>Its points</summary>\n" + points));
}

std::string formatParagraphs(std::string_view text) {
  std::string paragraphs;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (end > 0) paragraphs += element("p", escapeMarkup(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return paragraphs;
}

std::string formatPairs(const std::vector<std::pair<std::string, std::string>>& pairs,
                        std::string_view kind) {
  if (pairs.empty()) return "";
  std::string list = "\n";
  for (const auto& [name, value] : pairs)
    list += "<div><dt>" + escapeMarkup(name) + "</dt><dd>" + escapeMarkup(value) + "</dd></div>\n";
  return element("dl", list, fmt::format("class=\"{}\"", kind));
}

std::string formatHead(const Study& study, const std::string& missing) {
  std::vector<std::pair<std::string, std::string>> headlines;
  for (const auto& [name, value] : study.headlines) headlines.emplace_back(name, number(value));
  std::string contents;
  for (std::size_t i = 0; i < study.sections.size(); ++i)
    contents += element("li", element("a", escapeMarkup(study.sections[i].title),
                                      fmt::format("href=\"#section-{}\"", i + 1)));
  std::string head = element("h1", escapeMarkup(study.title)) + formatPairs(study.facts, "facts") +
                     formatPairs(headlines, "headlines");
  if (!missing.empty())
    head += element("p", "Charts are shown as tables of their points \u2014 " + escapeMarkup(missing) + ".",
                    "class=\"missing\" role=\"note\"");
  if (!contents.empty())
    head +=
        element("nav", element("h2", "Contents") + element("ol", "\n" + contents), "aria-label=\"Contents\"");
  return element("header", "\n" + head);
}

// Takes what drawings it needs from `svg` on.
std::string formatSection(const StudySection& section, std::size_t place, const StudyDrawings& drawings,
                          std::size_t& drawing) {
  std::string content = element("h2", escapeMarkup(section.title)) + formatParagraphs(section.text);
  if (!section.missing.empty())
    content += element("p", escapeMarkup(section.missing), "class=\"missing\" role=\"note\"");
  for (const StudyChart& chart : section.charts) {
    content += formatChart(chart, drawing < drawings.svgs.size() ? drawings.svgs[drawing] : "");
    ++drawing;
  }
  for (const StudyTable& table : section.tables) content += formatTable(table);
  if (!section.figures.empty())
    content += element("details", "<summary>Its figures</summary>\n" + formatTable(figuresOf(section)));
  return element("section", "\n" + content, fmt::format("id=\"section-{}\"", place));
}

Plot plotOf(const StudyChart& chart) {
  Plot plot{.title = chart.title,
            .xLabel = chart.xLabel,
            .yLabel = chart.yLabel,
            .logX = chart.logX,
            .logY = chart.logY,
            .curves = {},
            .titleInside = false};
  for (const StudyCurve& curve : chart.curves)
    plot.curves.push_back({.name = curve.name, .points = curve.points, .slope = curve.slope});
  return plot;
}

}  // namespace

StudyDrawings drawStudy(const Study& study, const Gnuplot& gnuplot) {
  StudyDrawings drawings;
  for (const StudySection& section : study.sections)
    for (const StudyChart& chart : section.charts) {
      Drawing drawing;
      if (drawings.missing.empty())
        drawing = drawPlot(plotOf(chart), fmt::format("chart{}", drawings.svgs.size() + 1), gnuplot);
      if (!drawing.missing.empty()) drawings.missing = drawing.missing;
      drawings.svgs.push_back(drawing.svg);
    }
  return drawings;
}

std::string formatStudyPage(const Study& study, const StudyDrawings& drawings) {
  std::string body = formatHead(study, drawings.missing);
  std::size_t drawing = 0;
  for (std::size_t i = 0; i < study.sections.size(); ++i)
    body += formatSection(study.sections[i], i + 1, drawings, drawing);
  const std::string head =
      "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\"/>\n<meta name=\"color-scheme\" content=\"light dark\"/>\n" +
      element("title", escapeMarkup(study.title)) + element("style", kStudyPageStyle);
  return "<!DOCTYPE html>\n" +
         element("html",
                 "\n" + element("head", "\n" + head) + element("body", "\n" + element("main", "\n" + body)),
                 "lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\"");
}

StudyFiles writeStudy(const std::filesystem::path& folder, const Study& study, const Gnuplot& gnuplot) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error && !std::filesystem::is_directory(folder))
    throw Error(folder.string(), "cannot be made: " + error.message(), "give another folder");
  const StudyDrawings drawings = drawStudy(study, gnuplot);
  const StudyFiles files{folder / "index.html", folder / "study.json", drawings.missing};
  writeFile(files.json, studyToJson(study));
  writeFile(files.page, formatStudyPage(study, drawings));
  return files;
}

}  // namespace shprt
