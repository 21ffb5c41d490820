// What cutting spherical harmonics off at a degree leaves out: of transfer, of the light, and of the radiance
// that they make together.
#pragma once

#include "shprt/study/study_run.h"

namespace shprt {

StudyExperiment degreeStudy(const StudyRun& run);

}  // namespace shprt
