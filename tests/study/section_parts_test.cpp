#include "shprt/study/section_parts.h"

#include <gtest/gtest.h>

namespace shprt {
namespace {

TEST(ShortNumber, KeepsTwoDigits) {
  EXPECT_EQ(shortNumber(0.01449), "0.014");
  EXPECT_EQ(shortNumber(38914.2), "39000");
  EXPECT_EQ(shortNumber(9.96), "10");
  EXPECT_EQ(shortNumber(152), "150");
  EXPECT_EQ(shortNumber(0), "0");
}

TEST(SectionParts, LeaveOutWhatLogarithmicAxesCannotShow) {
  StudyCurve curve = beginCurve("curve");
  addPoint(curve, 1, 0);
  StudySection section = beginSection("id", "title");
  StudyChart chart = beginChart("chart", "title", "x", "y");
  addCurve(chart, curve);
  addChart(section, chart);
  EXPECT_TRUE(section.charts.empty());
  addPoint(curve, 0, 0.5);
  addCurve(chart, curve);
  addChart(section, chart);
  ASSERT_EQ(section.charts.size(), 1u);
  EXPECT_EQ(section.charts.front().curves.size(), 1u);
  EXPECT_EQ(section.charts.front().curves.front().points.size(), 1u);
}

}  // namespace
}  // namespace shprt
