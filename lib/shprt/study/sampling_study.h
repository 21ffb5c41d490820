// Error of shadowed transfer against rays and against seconds: plain random directions, jittered, Sobol and
// the lattice of bakes.
#pragma once

#include "shprt/study/study_run.h"

namespace shprt {

StudyExperiment samplingStudy(const StudyRun& run);

}  // namespace shprt
