// The plan as a table and as JSON.
#include "shprt/report/plan_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace shprt {
namespace {

EffectPlan samplePlan() {
  EffectPlan plan;
  plan.model = "interreflected";
  plan.bounces = 3;
  plan.channels = 3;
  plan.vertices = 1234;
  plan.bytes = 5'583'908;
  plan.seconds = 1.25;
  plan.findings = {
      {"shadows", true, true, "12 of 1,234 vertices", {0.2, 0.1, 0.3}, 0.5, 0},
      {"glossy",
       true,
       false,
       "a line of evidence that is much too long for the column it has to stand in, and then some "
       "more so that it takes three lines in all",
       {0.25, 0.25, 0.25},
       0,
       0},
      {"near field", false, false, "no light is near", {}, 0, 0}};
  plan.degreeTails = {{0, 0.5, 0.4}, {1, 0, 0}};
  plan.pilot.bounces.resize(2);
  plan.pilot.bandEnergy = {1, 0.5};
  return plan;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(PlanReport, TableFitsAndKeepsEveryWord) {
  const std::string text = formatPlan(samplePlan());
  const std::vector<std::string> lines = linesOf(text);
  for (const std::string& line : lines) {
    EXPECT_LE(line.size(), 110u);
    EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
  }
  for (const char* words : {"0.1 to 0.3", "yes*", "0.25", "three lines in all", "no light is near",
                            "interreflected, 3 bounces", "three channels", "5.58 MB", "not simulated yet"})
    EXPECT_NE(text.find(words), std::string::npos) << words;
  EXPECT_EQ(lines[1].substr(0, 7), "shadows");
  EXPECT_EQ(text.back(), '\n');
}

TEST(PlanReport, JsonHoldsWhatThePlanSays) {
  const nlohmann::json json = nlohmann::json::parse(planToJson(samplePlan()));
  EXPECT_EQ(json.at("format"), "shprt-plan");
  EXPECT_EQ(json.at("model"), "interreflected");
  EXPECT_EQ(json.at("bounces"), 3);
  ASSERT_EQ(json.at("effects").size(), 3u);
  const nlohmann::json& shadows = json.at("effects")[0];
  EXPECT_EQ(shadows.at("effect"), "shadows");
  EXPECT_EQ(shadows.at("needed"), true);
  EXPECT_EQ(shadows.at("simulated"), true);
  EXPECT_EQ(shadows.at("evidence"), "12 of 1,234 vertices");
  EXPECT_EQ(shadows.at("contribution"), 0.2);
  EXPECT_EQ(shadows.at("low"), 0.1);
  EXPECT_EQ(shadows.at("high"), 0.3);
  EXPECT_EQ(shadows.at("seconds"), 0.5);
  EXPECT_EQ(json.at("pilot").at("bounces").size(), 2u);
  EXPECT_EQ(json.at("degreeTails")[0].at("radiance"), 0.4);
  EXPECT_EQ(planToJson(samplePlan()).find('\n'), std::string::npos);
}

TEST(PlanReport, EqualPlansGiveEqualText) {
  EXPECT_EQ(formatPlan(samplePlan()), formatPlan(samplePlan()));
  EXPECT_EQ(planToJson(samplePlan()), planToJson(samplePlan()));
}

}  // namespace
}  // namespace shprt
