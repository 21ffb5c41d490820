// What each source of error costs by itself: effects left out, bands cut off, few rays, halves.
#pragma once

#include "shprt/study/settings_search.h"
#include "shprt/study/study_reference.h"
#include "shprt/study/study_run.h"

namespace shprt {

inline constexpr int kCostSteps = 4;  // that it announces

// Bakes variants that differ from each other, or from the reference, in one thing only. The reference is not
// black.
ErrorCosts measureErrorCosts(StudyRun& run, StudyReference& reference);

}  // namespace shprt
