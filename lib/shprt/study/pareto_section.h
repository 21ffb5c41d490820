// The Pareto table as a section of the study's page.
#pragma once

#include "shprt/study/pareto.h"
#include "shprt/study/study.h"

namespace shprt {

StudySection paretoSection(const StudyRun& run, const StudyReference& reference, const Pareto& pareto);

// Where there is nothing to be relative to.
StudySection blackParetoSection();

}  // namespace shprt
