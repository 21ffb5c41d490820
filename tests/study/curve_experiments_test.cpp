#include "shprt/study/curve_experiments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "curve_run.h"

namespace shprt {
namespace {

Scene smallScene() {
  Mesh mesh;
  test::addPatch(mesh, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, 2);
  test::append(mesh, test::moved(test::makeIcosphere(0), 0.4, {0.2, 0.6, 0.1}));
  return test::grey(mesh, 0.5f);
}

struct MeasuredCurves {
  std::vector<StudySection> sections;
  std::size_t steps = 0;
};

MeasuredCurves measureAll(StudyRun& run) {
  MeasuredCurves measured;
  for (const StudyExperiment& experiment : curveExperiments(run)) {
    measured.steps += static_cast<std::size_t>(experiment.steps);
    measured.sections.push_back(experiment.measure(run));
    EXPECT_EQ(measured.sections.back().id, experiment.id);
  }
  return measured;
}

TEST(CurveExperiments, AnnounceAsManyStepsAsTheyPromise) {
  test::CurveRun lit(smallScene(), "interreflected");
  lit.lightBy(test::slopedMap(EnvironmentLayout::kLatitudeLongitude, 64, 32));
  const std::size_t steps = measureAll(lit.run).steps;
  EXPECT_EQ(lit.announced.size(), steps);
  EXPECT_EQ(std::set(lit.announced.begin(), lit.announced.end()).size(), lit.announced.size());
  test::CurveRun dark(smallScene());
  const std::size_t darkSteps = measureAll(dark.run).steps;
  EXPECT_EQ(dark.announced.size(), darkSteps);
  EXPECT_LT(dark.announced.size(), lit.announced.size());
}

TEST(CurveExperiments, MeasureNothingTwice) {
  test::CurveRun test(smallScene(), "interreflected");
  test.lightBy(test::slopedMap(EnvironmentLayout::kLatitudeLongitude, 64, 32));
  const MeasuredCurves first = measureAll(test.run);
  // Adaptive rays are compared with the lattice's errors and seconds, three of each; and the vertices are
  // drawn once for four experiments.
  EXPECT_EQ(test.run.journal.reused(), 6u + 3);
  const std::size_t steps = test.announced.size();
  const MeasuredCurves again = measureAll(test.run);
  // 6 sets of directions with 3 numbers of rays, errors and seconds; 3 adaptive bakes and what they are
  // compared with; 1 of degrees; 6 of bounces; 8 of storage; 6 of probes; the vertices.
  EXPECT_EQ(test.run.journal.reused(), 6u + 3 + 6 * 3 * 2 + 3 + 6 + 1 + 6 + 8 + 6 + 4);
  EXPECT_EQ(test.announced.size(), 2 * steps);
  for (std::size_t i = 0; i < first.sections.size(); ++i) {
    EXPECT_EQ(first.sections[i].figures, again.sections[i].figures);
    EXPECT_EQ(first.sections[i].text, again.sections[i].text);
  }
}

TEST(CurveExperiments, OtherSettingsHaveOtherKeys) {
  test::CurveRun test(smallScene(), "interreflected");
  test.lightBy(test::slopedMap(EnvironmentLayout::kLatitudeLongitude, 64, 32));
  measureAll(test.run);
  const std::size_t before = test.run.journal.reused();
  test.run.options.seed = 2;
  measureAll(test.run);
  EXPECT_EQ(test.run.journal.reused() - before, before);
}

TEST(CurveExperiments, NumbersAreFiniteAndNamedOnce) {
  test::CurveRun test(smallScene(), "interreflected");
  test.lightBy(test::slopedMap(EnvironmentLayout::kLatitudeLongitude, 64, 32));
  std::set<std::string> names;
  for (const StudySection& section : measureAll(test.run).sections) {
    EXPECT_TRUE(section.missing.empty()) << section.id;
    EXPECT_FALSE(section.text.empty());
    for (const auto& [name, number] : section.figures) {
      EXPECT_TRUE(std::isfinite(number)) << name;
      EXPECT_TRUE(names.insert(name).second) << name;
    }
    for (const StudyTable& table : section.tables)
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.id;
    for (const StudyChart& chart : section.charts)
      for (const StudyCurve& curve : chart.curves)
        for (const auto& [x, y] : curve.points) {
          EXPECT_TRUE(!chart.logX || x > 0) << chart.id << " " << curve.name;
          EXPECT_TRUE(!chart.logY || y > 0) << chart.id << " " << curve.name;
        }
  }
}

}  // namespace
}  // namespace shprt
