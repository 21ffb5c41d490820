// What storing an asset costs: bytes, seconds and error of every pixel type and compression.
#pragma once

#include "shprt/study/study_run.h"

namespace shprt {

StudyExperiment storageStudy(const StudyRun& run);

}  // namespace shprt
