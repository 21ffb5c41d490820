// Rays by an error that is asked for (BakeRequest::samplingError): what comes out, and what it takes, beside
// the same number of rays everywhere.
#pragma once

#include "shprt/study/study_run.h"

namespace shprt {

StudyExperiment adaptiveStudy(const StudyRun& run);

}  // namespace shprt
