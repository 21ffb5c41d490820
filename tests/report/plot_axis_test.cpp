// Axes: round ends around all values, rising labels within, whatever the values are.
#include "shprt/report/plot_axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "shprt/report/markup.h"

namespace shprt {
namespace {

std::vector<std::string> labels(const PlotAxis& axis) {
  std::vector<std::string> all;
  for (const auto& tic : axis.tics) all.push_back(tic.second);
  return all;
}

using Labels = std::vector<std::string>;

TEST(PlotAxis, HasStepsWhereItSpansLittleAndDecadesWhereMuch) {
  EXPECT_EQ(labels(chooseAxis({0.03, 1.9}, true)), (Labels{"0.02", "0.05", "0.1", "0.2", "0.5", "1", "2"}));
  EXPECT_EQ(labels(chooseAxis({1e-5, 0.5}, true)),
            (Labels{"10^{-5}", "10^{-4}", "0.001", "0.01", "0.1", "1"}));
  EXPECT_EQ(labels(chooseAxis({0, 9}, false)), (Labels{"0", "2", "4", "6", "8", "10"}));
  EXPECT_EQ(labels(chooseAxis({-1, 1}, false)), (Labels{"-1", "-0.5", "0", "0.5", "1"}));
}

TEST(PlotAxis, HasTheEdgesThatAreAskedFor) {
  const PlotAxis axis = chooseAxis({1, 1e9}, true, 1e-17, 10);
  EXPECT_NEAR(axis.low, 1e-17, 1e-30);
  EXPECT_EQ(axis.high, 10);
  EXPECT_EQ(axis.place(1e9), axis.high);
  EXPECT_EQ(axis.place(0), axis.low);
  EXPECT_TRUE(std::isnan(axis.place(NAN)));
}

TEST(PlotAxis, HoldsAllValuesWhateverTheyAre) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const bool logarithmic : {true, false})
    for (const std::vector<double>& values : std::vector<std::vector<double>>{{},
                                                                              {0},
                                                                              {-3},
                                                                              {7, 7},
                                                                              {NAN, infinity, -infinity},
                                                                              {1e-300, 1e300},
                                                                              {-1e308, 1e308},
                                                                              {1, 1 + 1e-15},
                                                                              {99.9999999, 1000.0000001}}) {
      const PlotAxis axis = chooseAxis(values, logarithmic);
      ASSERT_LT(axis.low, axis.high);
      ASSERT_TRUE(std::isfinite(axis.low) && std::isfinite(axis.high));
      EXPECT_FALSE(axis.tics.empty());
      EXPECT_LE(axis.tics.size(), 16u);
      for (std::size_t i = 0; i < axis.tics.size(); ++i) {
        EXPECT_GE(axis.tics[i].first, axis.low * (logarithmic ? 1 - 1e-9 : 1));
        if (i > 0) {
          EXPECT_GT(axis.tics[i].first, axis.tics[i - 1].first);
        }
      }
      for (const double value : values)
        if (std::isfinite(value) && (value > 0 || !logarithmic)) {
          EXPECT_NEAR(axis.place(value), value, 2e-9 * std::abs(value));
        }
    }
}

TEST(Markup, EscapesAndMendsText) {
  EXPECT_EQ(escapeMarkup("<a href=\"x\">'&'</a>"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
  EXPECT_EQ(plainLine("a\nb\tc\x7f"
                      "\x1b"),
            "a b c  ");
  const std::string good = "\xcf\x80\xe2\x82\xac\xf0\x9f\x98\x80";  // two, three and four bytes
  EXPECT_EQ(plainLine(good), good);
  const std::string mark = "\xef\xbf\xbd";
  EXPECT_EQ(plainLine("\x80"), mark);
  EXPECT_EQ(plainLine("\xe2\x82"), mark + mark);                        // cut short
  EXPECT_EQ(plainLine("\xc0\xaf"), mark + mark);                        // overlong
  EXPECT_EQ(plainLine("\xed\xa0\x80"), mark + mark + mark);             // a surrogate
  EXPECT_EQ(plainLine("\xf4\x90\x80\x80"), mark + mark + mark + mark);  // beyond the last
  EXPECT_EQ(plainLine("\xef\xbf\xbf"), mark + mark + mark);             // no character
}

}  // namespace
}  // namespace shprt
