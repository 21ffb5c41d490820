#include "shprt/study/bounce_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "../transfer/bowl.h"
#include "curve_run.h"

namespace shprt {
namespace {

TEST(BounceStudy, SaysWhyItIsMissingWhereNothingBounces) {
  test::CurveRun test(test::grey(test::makeIcosphere(1), 0.5f), "unshadowed");
  const StudyExperiment experiment = bounceStudy(test.run);
  const StudySection section = experiment.measure(test.run);
  EXPECT_EQ(experiment.steps, 0);
  EXPECT_TRUE(test.announced.empty());
  EXPECT_NE(section.missing.find("unshadowed"), std::string::npos);
  EXPECT_TRUE(section.tables.empty());
}

// In a bowl that is a fraction f of its sphere each bounce brings rho f times what the last one brought
// (bowl.h), and so does what is missing after it.
TEST(BounceStudy, BowlLosesTheSameShareWithEveryBounce) {
  test::CurveRun test(test::paintedBowl(0.5, {0.5f, 0.5f, 0.5f}, 12, 24), "interreflected");
  const StudySection section = bounceStudy(test.run).measure(test.run);
  for (int bounces = 0; bounces < 4; ++bounces) {
    const double ratio = test::figure(section, "bounces." + std::to_string(bounces + 1) + ".error") /
                         test::figure(section, "bounces." + std::to_string(bounces) + ".error");
    EXPECT_NEAR(ratio, 0.25, 0.02);
  }
  EXPECT_LE(test::figure(section, "bounces.auto.error"), test.run.options.error);
  EXPECT_EQ(section.charts.front().curves.back().points.front().first,
            test::figure(section, "bounces.auto.bounces"));
}

TEST(BounceStudy, KnowsTheScenesOwnLight) {
  Scene scene = test::paintedBowl(0.5, {0.5f, 0.5f, 0.5f}, 12, 24);
  scene.materials.front().emission = {1, 1, 1};
  test::CurveRun test(std::move(scene), "interreflected");
  const StudySection section = bounceStudy(test.run).measure(test.run);
  // Of radiance 1 / (1 - rho f): without bounces emitters and what they light are there, so n bounces leave
  // (rho f)^(n+2) of it out.
  EXPECT_NEAR(test::figure(section, "bounces.0.emissionError"), std::pow(0.25, 2), 0.003);
  EXPECT_NEAR(test::figure(section, "bounces.1.emissionError"), std::pow(0.25, 3), 0.001);
}

}  // namespace
}  // namespace shprt
