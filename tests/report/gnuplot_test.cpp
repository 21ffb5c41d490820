// Plots: whole whatever they are given, and a reason instead of a picture where gnuplot does not help. What
// needs gnuplot itself is skipped where there is none.
#include "shprt/report/gnuplot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "tests/scratch.h"

namespace shprt {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Plot lineOfDecades() {
  return {.title = "t",
          .xLabel = "x",
          .yLabel = "y",
          .curves = {{.name = "c", .points = {{1, 1e-3}, {10, 1e-2}, {100, 1e-1}}}}};
}

// A program of our own in gnuplot's place.
std::string script(const std::string& name, const std::string& body) {
  const std::string path = test::writeScratch(name, "#!/bin/sh\n" + body + "\n");
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

std::string complaint(const std::string& program) {
  const Drawing drawing = drawPlot(lineOfDecades(), "p", {.program = program});
  EXPECT_EQ(drawing.svg, "");
  return drawing.missing;
}

std::string drawn(const Plot& plot, const std::string& name = "p") {
  const Drawing drawing = drawPlot(plot, name);
  EXPECT_EQ(drawing.missing, "");
  EXPECT_TRUE(drawing.svg.starts_with("<svg ") && drawing.svg.ends_with("</svg>\n")) << drawing.svg;
  return drawing.svg;
}

class WithGnuplot : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v gnuplot >/dev/null") != 0) GTEST_SKIP() << "SKIPPED: there is no gnuplot";
  }
};

TEST(Gnuplot, ThatIsMissingIsAReason) {
  const std::string reason = complaint("no-such-gnuplot");
  EXPECT_NE(reason.find("no-such-gnuplot"), std::string::npos);
  EXPECT_NE(reason.find("apt-get install gnuplot-nox"), std::string::npos);
}

TEST(Gnuplot, ThatFailsIsAReason) {
  const std::string reason = complaint(script("fails", "echo '\"-\" line 3: out of <ink>' >&2; exit 3"));
  EXPECT_NE(reason.find("exit code 3"), std::string::npos) << reason;
  EXPECT_NE(reason.find("out of <ink>"), std::string::npos) << reason;
  EXPECT_EQ(reason.find('\n'), std::string::npos);
  EXPECT_NE(complaint(script("crashes", "kill -SEGV $$")).find("signal 11"), std::string::npos);
  EXPECT_NE(complaint(script("is_silent", "exit 0")).find("no picture"), std::string::npos);
  EXPECT_NE(complaint(script("is_odd", "echo '</svg><title><svg'")).find("no picture"), std::string::npos);
  EXPECT_NE(complaint(std::filesystem::temp_directory_path()).find("cannot be started"), std::string::npos);
}

TEST(Gnuplot, ThatHangsIsEnded) {
  const std::string program = script("hangs", "sleep 600");
  const auto begin = std::chrono::steady_clock::now();
  const Drawing drawing =
      drawPlot(lineOfDecades(), "p", {.program = program, .limit = std::chrono::milliseconds(50)});
  // The limit of this is not how fast it is, but that it is not what `sleep` takes.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(300));
  EXPECT_NE(drawing.missing.find("longer than 0.05 seconds"), std::string::npos) << drawing.missing;
}

TEST(Gnuplot, ThatWritesWithoutEndIsEnded) {
  for (const char* stream : {"", " >&2"}) {
    const std::string reason = complaint(script("floods", std::string("yes '<svg><title>'") + stream));
    EXPECT_NE(reason.find("wrote more than 64 MB"), std::string::npos) << reason;
  }
}

TEST(Gnuplot, GetsItsWholeInputAndGivesItsWholeOutput) {
  Plot plot = lineOfDecades();
  for (int i = 0; i < 100000; ++i) plot.curves[0].points.emplace_back(i + 1, 1.0 / (i + 1));
  const std::string program = script("echoes", "echo '<svg ><title></title>'; cat; echo '</svg>'");
  const std::string svg = drawPlot(plot, "p", {.program = program}).svg;
  EXPECT_GT(svg.size(), 1'000'000u);
  EXPECT_NE(svg.find("\n100000 1e-05\n"), std::string::npos);
}

TEST(Gnuplot, PointsStandOnTheEdgeTheyAreBeyond) {
  Plot plot = lineOfDecades();
  plot.yLow = 1e-3, plot.yHigh = 1;
  plot.curves[0].points = {{1, 0}, {10, -1}, {0, 1e-2}, {100, kInfinity}, {100, 1e9}, {100, NAN}};
  const std::string program = script("echoes", "echo '<svg ><title></title>'; cat; echo '</svg>'");
  const std::string svg = drawPlot(plot, "p", {.program = program}).svg;
  EXPECT_NE(svg.find("\n1 0.001\n10 0.001\n1 0.01\n100 1\n100 1\n100 NaN\n"), std::string::npos) << svg;
}

TEST(Gnuplot, FittedLinesGoThroughTheMiddle) {
  // y = 2 / x but for factors of 2 and 1/2, which cancel in the logarithm: the line ends at 2 and at 0.02.
  Plot plot = lineOfDecades();
  plot.curves[0].points = {{1, 2}, {10, 0.4}, {10, 0.1}, {100, 0.02}};
  plot.curves[0].slope = -1;
  const std::string program = script("echoes", "echo '<svg ><title></title>'; cat; echo '</svg>'");
  const std::string svg = drawPlot(plot, "p", {.program = program}).svg;
  const std::size_t at = svg.find("$fit0");
  ASSERT_NE(at, std::string::npos) << svg;
  double x1 = 0, y1 = 0, x2 = 0, y2 = 0;
  ASSERT_EQ(std::sscanf(svg.c_str() + svg.find('\n', at), "%lf %lf %lf %lf", &x1, &y1, &x2, &y2), 4);
  EXPECT_EQ(x1, 1);
  EXPECT_EQ(x2, 100);
  EXPECT_NEAR(y1, 2, 1e-12);
  EXPECT_NEAR(y2, 0.02, 1e-14);
  EXPECT_NE(svg.find("slope -1.00"), std::string::npos);
}

TEST_F(WithGnuplot, PicturesAreWholeWhateverTheyAreGiven) {
  for (const bool logarithmic : {true, false})
    for (const std::vector<PlotCurve>& curves :
         std::vector<std::vector<PlotCurve>>{{},
                                             {{"empty", {}}},
                                             {{"zero", {{0, 0}}}},
                                             {{"negative", {{-1, -2}, {-3, -4}}}},
                                             {{"no numbers", {{NAN, NAN}, {kInfinity, -kInfinity}}}},
                                             {{"far", {{1e-300, 1e300}, {1e300, 1e-300}, {5e-324, 1}}}},
                                             {{"near", {{1, 1}, {1 + 1e-15, 1 - 1e-15}}, true}},
                                             {{"a fit", {{1, 1}, {2, 3}, {0, 0}}, false, 1.5}}}) {
      const std::string svg = drawn({.title = "t",
                                     .xLabel = "",
                                     .yLabel = "",
                                     .logX = logarithmic,
                                     .logY = logarithmic,
                                     .curves = curves});
      EXPECT_EQ(svg.find("nan"), std::string::npos);
    }
}

TEST_F(WithGnuplot, TextsAreTextsAndNoCommands) {
  const std::string bait = test::scratch("bait");
  const std::string odd = "it's \"{x_2}\" <b>&amp; \\n @X %g ${a} id='q' `touch " + bait + "`";
  Plot plot = lineOfDecades();
  plot.title = plot.xLabel = plot.yLabel = plot.curves[0].name = odd;
  const std::string svg = drawn(plot);
  EXPECT_FALSE(std::filesystem::exists(bait));
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  std::size_t seen = 0;
  for (std::size_t at = 0; (at = svg.find("{x_2}", at)) != std::string::npos; ++at) ++seen;
  EXPECT_EQ(seen, 6u);  // label, title, and four times in the picture
  plot.title = "line\nbreak \x01 \xff\xc3";
  EXPECT_NE(drawn(plot).find("line break   \xef\xbf\xbd\xef\xbf\xbd"), std::string::npos);
}

std::vector<std::string> idsOf(const std::string& svg) {
  std::vector<std::string> ids;
  for (std::size_t at = 0; (at = svg.find(" id=", at)) != std::string::npos; at += 5)
    ids.push_back(svg.substr(at + 5, svg.find(svg[at + 4], at + 5) - at - 5));
  return ids;
}

TEST_F(WithGnuplot, IdsAreTheOwnOfEachPicture) {
  const std::string svg = drawn(lineOfDecades(), "one");
  const std::vector<std::string> ids = idsOf(svg);
  EXPECT_FALSE(ids.empty());
  for (const std::string& id : ids) EXPECT_TRUE(id.starts_with("one-")) << id;
  // What refers to an id refers to one that is there.
  for (std::size_t at = 0; (at = svg.find("href='#", at)) != std::string::npos; at += 7) {
    const std::string id = svg.substr(at + 7, svg.find('\'', at + 7) - at - 7);
    EXPECT_NE(std::find(ids.begin(), ids.end(), id), ids.end()) << id;
  }
}

TEST_F(WithGnuplot, EqualPlotsGiveEqualFiles) {
  const std::string one = test::scratch("one.svg"), two = test::scratch("two.svg");
  writePlot(one, lineOfDecades());
  writePlot(two, lineOfDecades());
  EXPECT_EQ(readFile(one), readFile(two));
  EXPECT_THROW(writePlot(one, lineOfDecades(), {.program = "no-such-gnuplot"}), Error);
  EXPECT_EQ(readFile(one), readFile(two));
}

}  // namespace
}  // namespace shprt
