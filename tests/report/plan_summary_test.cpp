// A recorded plan in words, however much or little it says.
#include <gtest/gtest.h>

#include "shprt/report/plan_summary.h"

namespace shprt {
namespace {

TEST(PlanSummary, SaysWhetherAndWhy) {
  const std::vector<PlannedEffect> effects = summarisePlan(R"({"bounces":3,"effects":[
    {"effect":"shadows","needed":true,"simulated":true,"evidence":"12% have something above them","contribution":0.25},
    {"effect":"interreflection","needed":false,"simulated":false,"evidence":"all is black"},
    {"effect":"glossy","needed":true,"simulated":false},
    {"effect":"colour","needed":false,"simulated":true,"contribution":0}]})");
  ASSERT_EQ(effects.size(), 4u);
  EXPECT_EQ(effects[0].effect, "shadows");
  EXPECT_EQ(effects[0].what, "needed: 12% have something above them; contribution 0.25");
  EXPECT_EQ(effects[1].what, "skipped: all is black");
  EXPECT_EQ(effects[2].what, "needed, but not simulated");
  EXPECT_EQ(effects[3].what, "simulated, though not needed; contribution 0");
}

TEST(PlanSummary, ToleratesWhatItDoesNotKnow) {
  for (const char* plan :
       {"", "{}", "[]", "3", R"({"effects":{}})", R"({"effects":[]})", R"({"effects":[1,"a",null]})"})
    EXPECT_TRUE(summarisePlan(plan).empty()) << plan;
  const std::vector<PlannedEffect> effects = summarisePlan(
      R"({"effects":[{},{"effect":3,"needed":"perhaps","simulated":false,"evidence":["a"],"contribution":{"mean":1}},
                     {"effect":"x","evidence":"two\nlines"}]})");
  ASSERT_EQ(effects.size(), 3u);
  EXPECT_EQ(effects[0].effect, "effect");
  EXPECT_EQ(effects[0].what, "");
  EXPECT_EQ(effects[1].what, "skipped");
  EXPECT_EQ(effects[2].what, "two lines");
}

}  // namespace
}  // namespace shprt
