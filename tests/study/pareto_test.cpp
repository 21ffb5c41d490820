// The Pareto table on scenes of a few hundred vertices.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "shprt/study/pareto.h"
#include "shprt/study/pareto_section.h"
#include "shprt/study/run_study.h"
#include "shprt/study/settings_search.h"
#include "shprt/study/study_bake.h"
#include "tests/scratch.h"
#include "tests/transfer/test_meshes.h"

namespace shprt {
namespace {

using test::addPatch;
using test::append;
using test::grey;
using test::makeBox;
using test::makeIcosphere;

// A box that hovers above a floor.
Scene shadedScene() {
  Mesh mesh;
  addPatch(mesh, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0}, 8);
  append(mesh, makeBox({-0.5, 0.3, -0.5}, {1, 1, 1}, 2));
  return grey(mesh, 0.6f);
}

// Bands that fall off as those of a sky do.
StudyLight smoothLight() {
  StudyLight light;
  light.name = light.arguments = "sky.json";
  light.coefficients.degree = 3;
  for (int l = 0; l <= 3; ++l)
    for (int m = -l; m <= l; ++m) {
      const double value = m == 0 ? 2.0 / (1 + l * l) : 0.3 / (1 + l * l);
      light.coefficients.coefficients.push_back({value, 0.8 * value, 0.5 * value});
    }
  return light;
}

struct Bench {
  Scene scene;
  PreparedScene prepared;
  StudyJournal journal;
  int announced = 0;
  StudyRun run;

  Bench(Scene of, std::optional<StudyLight> light, const std::string& path = "")
      : scene(std::move(of)),
        prepared(scene),
        journal(path, "test"),
        run{.prepared = prepared,
            .scene = "scene.obj",
            .arguments = "scene.obj",
            .light = std::move(light),
            .options = {.quick = true},
            .plan = {},
            .journal = journal,
            .announce = [this](const std::string&) { ++announced; }} {
    std::vector<LightCoefficients> lights;
    if (run.light) lights.push_back(run.light->coefficients);
    run.plan = planEffects(prepared, lights, {});
  }
};

// What another bake of the row's settings has, measured by hand.
double radianceErrorOf(const Bench& bench, const BakeSettings& settings) {
  BakeRequest best;
  best.degree = 3;
  best.rays = 16384;
  best.seed = 4711;
  best.error = 1e-4;
  const StudyBake reference = bakeForStudy(bench.run, best),
                  judged = bakeForStudy(bench.run, settings.request);
  double difference = 0, norm = 0;
  const LightCoefficients& light = bench.run.light->coefficients;
  for (std::size_t v = 0; v < reference.asset.positions.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c) {
      double a = 0, b = 0;
      for (int i = 0; i < coefficientCount(3); ++i)
        a += double(reference.asset.transfer.row(0, i)[v]) * light.coefficients[std::size_t(i)][c];
      for (int i = 0; i < coefficientCount(std::min(3, judged.asset.transfer.degree)); ++i)
        b += double(judged.asset.transfer.row(0, i)[v]) * light.coefficients[std::size_t(i)][c];
      difference += (a - b) * (a - b);
      norm += a * a;
    }
  return std::sqrt(difference / norm);
}

void expectMonotone(const Pareto& pareto) {
  for (std::size_t i = 1; i < pareto.rows.size(); ++i) {
    const ParetoRow &loose = pareto.rows[i - 1], &fine = pareto.rows[i];
    EXPECT_GT(loose.target, fine.target);
    if (!fine.reached) continue;
    EXPECT_TRUE(loose.reached);
    EXPECT_LE(priceOf(loose.best.seconds, loose.best.bytes), priceOf(fine.best.seconds, fine.best.bytes));
  }
}

TEST(Pareto, RowsReachTheirTargetsUnderALight) {
  Bench bench(shadedScene(), smoothLight());
  StudyReference reference(bench.run);
  const Pareto pareto = measurePareto(bench.run, reference);
  ASSERT_EQ(pareto.rows.size(), 5u);
  expectMonotone(pareto);
  EXPECT_TRUE(pareto.rows[2].reached);  // 1% takes some hundred rays
  for (const ParetoRow& row : pareto.rows) {
    if (!row.reached) continue;
    EXPECT_LE(row.best.error, row.target);
    // Both references have noise of their own, a quarter of the finest row's or less.
    EXPECT_LE(radianceErrorOf(bench, row.best.settings), 1.1 * row.target + 2e-4) << row.target;
  }
}

TEST(Pareto, WithoutALightTheDegreeStays) {
  Bench bench(shadedScene(), {});
  StudyReference reference(bench.run);
  const Pareto pareto = measurePareto(bench.run, reference);
  expectMonotone(pareto);
  EXPECT_TRUE(pareto.rows[1].reached);
  for (const MeasuredSettings& measured : pareto.measured) EXPECT_EQ(measured.settings.request.degree, 4);
}

TEST(Pareto, WhatNothingShadowsNeedsNoRays) {
  Bench bench(grey(makeIcosphere(2), 0.8f), smoothLight());
  StudyReference reference(bench.run);
  const Pareto pareto = measurePareto(bench.run, reference);
  expectMonotone(pareto);
  for (const ParetoRow& row : pareto.rows) {
    EXPECT_TRUE(row.reached) << row.target;
    EXPECT_EQ(row.best.settings.request.model, "unshadowed");
  }
  // Band 3 of unshadowed transfer is zero, whatever the light. (Which of several is cheapest, times decide.)
  EXPECT_TRUE(
      std::any_of(pareto.measured.begin(), pareto.measured.end(), [&](const MeasuredSettings& measured) {
        return measured.settings.request.degree <= 2 && measured.error <= pareto.rows.back().target;
      }));
}

TEST(Pareto, SaysSoWhereNothingIsLit) {
  StudyLight black;
  black.name = "black.json";
  black.coefficients.coefficients = {{0, 0, 0}};
  Bench bench(grey(makeIcosphere(0), 0.8f), black);
  const StudySection section = paretoExperiment().measure(bench.run);
  EXPECT_FALSE(section.missing.empty());
  EXPECT_TRUE(section.tables.empty());
}

TEST(Pareto, SectionHasARowAndFiguresPerTarget) {
  Bench bench(grey(makeIcosphere(1), 0.8f), smoothLight());
  const std::vector<StudyExperiment> experiments = {paretoExperiment()};
  const Study study = runStudy(bench.run, experiments);
  EXPECT_EQ(bench.announced, countSteps(experiments));
  ASSERT_EQ(study.sections.size(), 1u);
  const StudySection& section = study.sections[0];
  ASSERT_EQ(section.tables.at(0).rows.size(), 6u);
  for (const auto& row : section.tables[0].rows) {
    EXPECT_EQ(row.size(), section.tables[0].columns.size());
    EXPECT_TRUE(row.back().starts_with("shprt bake scene.obj -o ")) << row.back();
  }
  const auto figure = [&](const std::string& name) {
    return std::count_if(section.figures.begin(), section.figures.end(),
                         [&](const auto& one) { return one.first == name; });
  };
  for (const char* name : {"pareto.default.error", "pareto.0.1.seconds", "pareto.0.001.bytes"})
    EXPECT_EQ(figure(name), 1) << name;
  EXPECT_EQ(study.headlines.size(), 7u);
}

TEST(Pareto, MeasuresNothingTwice) {
  const std::string path = test::scratch("journal.json");
  std::filesystem::remove(path);
  Bench first(shadedScene(), smoothLight(), path);
  const StudySection once = paretoExperiment().measure(first.run);
  Bench second(shadedScene(), smoothLight(), path);
  // Anything that is baked reports its progress; nothing may be.
  second.run.progress = [](const ProgressReport&) { FAIL() << "something was baked"; };
  const StudySection again = paretoExperiment().measure(second.run);
  EXPECT_EQ(once.figures, again.figures);
  EXPECT_EQ(once.tables[0].rows, again.tables[0].rows);
}

}  // namespace
}  // namespace shprt
