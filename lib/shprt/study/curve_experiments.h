// The experiments of a study that vary one setting each.
#pragma once

#include <vector>

#include "shprt/study/study_run.h"

namespace shprt {

// Rays, rays by error, degree, bounces, storage, probe resolution, in this order. Only steps depend on the
// run.
std::vector<StudyExperiment> curveExperiments(const StudyRun& run);

}  // namespace shprt
