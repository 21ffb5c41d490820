#include "shprt/study/curve_experiments.h"

#include "shprt/study/adaptive_study.h"
#include "shprt/study/bounce_study.h"
#include "shprt/study/degree_study.h"
#include "shprt/study/probe_study.h"
#include "shprt/study/sampling_study.h"
#include "shprt/study/storage_study.h"

namespace shprt {

std::vector<StudyExperiment> curveExperiments(const StudyRun& run) {
  return {samplingStudy(run), adaptiveStudy(run), degreeStudy(run),
          bounceStudy(run),   storageStudy(run),  probeStudy(run)};
}

}  // namespace shprt
