// What stopping after so many bounces leaves out, and where bakes stop by themselves.
#pragma once

#include "shprt/study/study_run.h"

namespace shprt {

StudyExperiment bounceStudy(const StudyRun& run);

}  // namespace shprt
