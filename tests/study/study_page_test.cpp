// The page and the JSON of a made-up study: nothing of it gets lost, nothing gets out of its place.
#include "shprt/study/study_page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/study/study_json.h"
#include "tests/scratch.h"

namespace shprt {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::string kCommand = "shprt bake 'a & b.obj' --rays 256 -o <out>";

Study madeUp() {
  Study study{.title = "bunny <&> \"sky\"",
              .facts = {{"scene", "a & b.obj"}, {"a \"fact\"", "</dl>"}},
              .headlines = {{"rays for 1%", 256}, {"times fewer", NAN}},
              .sections = {}};
  StudySection rays{.id = "rays",
                    .title = "Error <b> & rays",
                    .text = "First <i>.\nSecond.\n",
                    .charts = {},
                    .tables = {},
                    .figures = {{"a", 0.1}, {"b", kInfinity}, {"third", 1.0 / 3}},
                    .missing = ""};
  rays.charts.push_back({"one", "Chart <1>", "rays & more", "error", true, true, {}});
  rays.charts[0].curves.push_back({"sobol \"&\"", {{16, 0.125}, {32, 0}, {64, NAN}, {128, -1}}, -0.75});
  rays.charts[0].curves.push_back({"none", {}, {}});
  rays.charts.push_back({"two", "Chart 2", "x", "y", false, true, {{"c", {{1, 2}, {3, 4}}, {}}}});
  rays.tables.push_back(
      {"t", "Table <t>", {"error", "command"}, {{"1%", kCommand}, {"3%", "none <yet>"}, {}}});
  study.sections = {
      rays,
      {.id = "empty", .title = "", .text = "", .charts = {}, .tables = {}, .figures = {}, .missing = ""}};
  study.sections.push_back({.id = "probe",
                            .title = "Probe",
                            .text = "",
                            .charts = {},
                            .tables = {},
                            .figures = {},
                            .missing = "needs <an image>"});
  return study;
}

const StudyDrawings kNotDrawn{{}, "no plots; apt-get install gnuplot-nox"};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t seen = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++seen;
  return seen;
}

// Well-formed as far as elements go: each tag that opens is closed in its turn. Returns what is wrong.
std::string faultOf(const std::string& page) {
  std::vector<std::string> open;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at)) {
    const std::size_t end = page.find('>', at);
    if (end == std::string::npos) return "a tag does not end";
    const std::string tag = page.substr(at + 1, end - at - 1);
    at = end;
    if (tag.starts_with("!") || tag.ends_with("/")) continue;
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (!name.starts_with("/")) {
      open.push_back(name);
    } else if (open.empty() || "/" + open.back() != name) {
      return "<" + name + "> closes nothing";
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> stays open";
}

bool haveGnuplot() {
  return std::system("command -v gnuplot >/dev/null") == 0;
}

TEST(StudyPage, HoldsAllOfTheStudyEscaped) {
  const std::string page = formatStudyPage(madeUp(), kNotDrawn);
  EXPECT_EQ(faultOf(page), "");
  for (const char* part : {"<title>bunny &lt;&amp;&gt; &quot;sky&quot;</title>",
                           "a &amp; b.obj",
                           "&lt;/dl&gt;",
                           "<dd>256</dd>",
                           "<dd>\u2013</dd>",
                           "href=\"#section-1\"",
                           "id=\"section-3\"",
                           "Error &lt;b&gt; &amp; rays",
                           "<p>First &lt;i&gt;.</p>",
                           "<p>Second.</p>",
                           "Chart &lt;1&gt;",
                           "sobol &quot;&amp;&quot;",
                           "0.125",
                           "Fitted slopes: sobol &quot;&amp;&quot; -0.75.",
                           "Table &lt;t&gt;",
                           "none &lt;yet&gt;",
                           "needs &lt;an image&gt;",
                           "apt-get install gnuplot-nox",
                           "0.3333",
                           "\u221e"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(count(page, "<section "), 3u);
  EXPECT_EQ(count(page, "<figure>"), 2u);
  EXPECT_EQ(count(page, "<p></p>"), 0u);
  EXPECT_NE(page.find("<code>shprt bake &#39;a &amp; b.obj&#39; --rays 256 -o &lt;out&gt;</code>"),
            std::string::npos);
}

TEST(StudyPage, NeedsNothingElse) {
  const std::string page = formatStudyPage(madeUp(), haveGnuplot() ? drawStudy(madeUp()) : kNotDrawn);
  for (const char* outside : {"src=", "<link", "<script", "@import", "href=\"http", "href='http", "url(http"})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
}

TEST(StudyPage, OfNothingIsAPage) {
  const std::string page = formatStudyPage({}, {});
  EXPECT_EQ(faultOf(page), "");
  EXPECT_EQ(page.find("<nav"), std::string::npos);
  EXPECT_EQ(page.find("class=\"missing\""), std::string::npos);
}

TEST(StudyPage, StandsWhereGnuplotDoesNotHelp) {
  const std::string fails = test::writeScratch("fails", "#!/bin/sh\necho x >>\"$0.log\"\nexit 1\n");
  std::filesystem::remove(fails + ".log");
  std::filesystem::permissions(fails, std::filesystem::perms::owner_all);
  for (const std::string& program : {std::string("no-such-gnuplot"), fails}) {
    const StudyDrawings drawings = drawStudy(madeUp(), {.program = program});
    EXPECT_EQ(drawings.svgs, (std::vector<std::string>{"", ""}));
    EXPECT_NE(drawings.missing, "");
    EXPECT_EQ(faultOf(formatStudyPage(madeUp(), drawings)), "");
  }
  EXPECT_EQ(readFile(fails + ".log"), "x\n");  // not asked a second time
}

TEST(StudyPage, HasItsChartsInItWithIdsOfTheirOwn) {
  if (!haveGnuplot()) GTEST_SKIP() << "SKIPPED: there is no gnuplot";
  const StudyDrawings drawings = drawStudy(madeUp());
  EXPECT_EQ(drawings.missing, "");
  const std::string page = formatStudyPage(madeUp(), drawings);
  EXPECT_EQ(faultOf(page), "");
  EXPECT_EQ(count(page, "<svg "), 2u);
  EXPECT_EQ(count(page, "role=\"img\" aria-label=\"Chart "), 2u);
  EXPECT_EQ(count(page, "<summary>Its points</summary>"), 2u);
  EXPECT_EQ(page.find("role=\"note\">Charts"), std::string::npos);
  std::set<std::string> ids;
  for (std::size_t at = 0; (at = page.find(" id=", at)) != std::string::npos; at += 5)
    EXPECT_TRUE(ids.insert(page.substr(at + 5, page.find(page[at + 4], at + 5) - at - 5)).second);
  EXPECT_GT(ids.size(), 5u);
}

TEST(StudyJson, HoldsEveryNumber) {
  const nlohmann::json json = nlohmann::json::parse(studyToJson(madeUp()));
  EXPECT_EQ(json["format"], "shprt-study");
  EXPECT_EQ(json["title"], "bunny <&> \"sky\"");
  EXPECT_EQ(json["facts"]["scene"], "a & b.obj");
  EXPECT_EQ(json["headlines"]["rays for 1%"], 256);
  EXPECT_TRUE(json["headlines"]["times fewer"].is_null());
  const nlohmann::json& rays = json["sections"][0];
  EXPECT_FALSE(rays.contains("missing"));
  EXPECT_EQ(rays["text"], "First <i>.\nSecond.\n");
  EXPECT_EQ(rays["figures"]["third"].get<double>(), 1.0 / 3);
  EXPECT_TRUE(rays["figures"]["b"].is_null());
  const nlohmann::json& chart = rays["charts"][0];
  EXPECT_EQ(chart["x"], nlohmann::json({{"label", "rays & more"}, {"logarithmic", true}}));
  EXPECT_EQ(chart["curves"][0]["slope"], -0.75);
  EXPECT_TRUE(chart["curves"][1]["slope"].is_null());
  EXPECT_EQ(chart["curves"][0]["points"],
            nlohmann::json::parse("[[16.0,0.125],[32.0,0.0],[64.0,null],[128.0,-1.0]]"));
  EXPECT_FALSE(rays["charts"][1]["x"]["logarithmic"].get<bool>());
  EXPECT_EQ(rays["tables"][0]["rows"][0][1], kCommand);
  EXPECT_EQ(json["sections"][1]["charts"], nlohmann::json::array());
  EXPECT_EQ(json["sections"][1]["figures"], nlohmann::json::object());
  EXPECT_EQ(json["sections"][2]["missing"], "needs <an image>");
}

TEST(StudyJson, IsJsonOfBytesThatAreNoText) {
  EXPECT_EQ(nlohmann::json::parse(studyToJson({.title = "\xff", .facts = {}, .sections = {}}))["title"],
            "\xef\xbf\xbd");
}

TEST(WriteStudy, WritesPageAndNumbers) {
  const std::string folder = test::scratch("made") + "/study";
  std::filesystem::remove_all(folder);
  const Gnuplot none{.program = "no-such-gnuplot"};
  const StudyFiles files = writeStudy(folder, madeUp(), none);
  EXPECT_EQ(readFile(files.page), formatStudyPage(madeUp(), drawStudy(madeUp(), none)));
  EXPECT_EQ(readFile(files.json), studyToJson(madeUp()));
  EXPECT_NE(files.missing, "");
  std::size_t entries = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) entries += entry.exists() ? 1 : 0;
  EXPECT_EQ(entries, 2u);
  writeStudy(folder, {}, none);  // in place of what was there
  EXPECT_EQ(readFile(files.json), studyToJson({}));
}

TEST(WriteStudy, SaysWhenItCannot) {
  const std::string file = test::writeScratch("a_file", "content");
  EXPECT_THROW(writeStudy(file, {}), Error);
  EXPECT_THROW(writeStudy(file + "/below", {}), Error);
  EXPECT_EQ(readFile(file), "content");
}

}  // namespace
}  // namespace shprt
