// What a light probe of lower resolution leaves out of its coefficients and of radiance.
#pragma once

#include "shprt/study/study_run.h"

namespace shprt {

StudyExperiment probeStudy(const StudyRun& run);

}  // namespace shprt
