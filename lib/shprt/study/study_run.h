// What every experiment of a study works with.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "shprt/base/progress.h"
#include "shprt/coefficients/light_coefficients.h"
#include "shprt/coefficients/transfer_asset.h"
#include "shprt/image/environment.h"
#include "shprt/study/study.h"
#include "shprt/study/study_journal.h"
#include "shprt/transfer/effect_plan.h"
#include "shprt/transfer/prepared_scene.h"

namespace shprt {

// The light that errors of radiance are measured under.
struct StudyLight {
  std::string name;                   // as given on the command line
  std::optional<EnvironmentMap> map;  // where it is an image: what truth is traced against
  LightCoefficients coefficients;     // to kMaximumBakeDegree (lights known to lower degree: to theirs)
  std::string arguments = {};         // as it goes into command lines: "sky.hdr --layout latlong"
};

struct StudyOptions {
  bool quick = false;  // under a minute on a mesh of 35,000 vertices: smaller references, fewer settings
  int degree = 4;      // the default settings, whose errors are asked for
  int rays = 256;
  double error = 0.01;  // that effects and bounces may leave out
  std::uint64_t seed = 1;
};

struct StudyRun {
  const PreparedScene& prepared;
  std::string scene;                // as given on the command line
  std::string arguments;            // of it, as they go into command lines: "bunny.obj --albedo 0.5"
  std::optional<StudyLight> light;  // without: sections that need one say so
  StudyOptions options;
  EffectPlan plan;        // of the default settings: plan.model is what is studied
  StudyJournal& journal;  // keeps what was measured, so that a study can go on after a break
  std::function<void(const std::string& what)>
      announce;                    // what is measured next; counts as one step of progress
  ProgressCallback progress = {};  // for long work within a step to report to; may throw to end the study
};

// An experiment adds its section; it announces `steps` times.
struct StudyExperiment {
  std::string id;
  int steps;
  std::function<StudySection(StudyRun&)> measure;
};

}  // namespace shprt
