// What each accuracy costs at least: the cheapest settings for a few errors, baked, measured, and with the
// command line that repeats them.
#pragma once

#include <vector>

#include "shprt/study/bake_settings.h"
#include "shprt/study/settings_search.h"
#include "shprt/study/study_reference.h"
#include "shprt/study/study_run.h"

namespace shprt {

// A bake as `shprt bake` makes it, from the scene in memory to the file.
struct MeasuredSettings {
  BakeSettings settings;
  double error = 0;    // of the asset as read, against the reference
  double seconds = 0;  // of rays, bounces and writing
  double bytes = 0;    // of the file
  double relightSeconds = 0;
};

struct ParetoRow {
  double target = 0;
  bool reached = false;
  MeasuredSettings best;  // the cheapest of all measured that reach it; where none does, that of least error
};

struct Pareto {
  ErrorCosts costs;           // of each source alone, what was searched
  MeasuredSettings defaults;  // what the plan makes of the run's options
  std::vector<ParetoRow> rows;
  std::vector<MeasuredSettings> measured;  // all, defaults included, in the order of making
};

// Rows for targets 10%, 3%, 1%, 0.3% and 0.1%. A smaller target never costs less, by priceOf(). The reference
// is not black.
Pareto measurePareto(StudyRun& run, StudyReference& reference);

StudyExperiment paretoExperiment();

}  // namespace shprt
