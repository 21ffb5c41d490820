// All experiments of a study, in the order of its page.
#pragma once

#include <vector>

#include "shprt/study/study.h"
#include "shprt/study/study_run.h"

namespace shprt {

std::vector<StudyExperiment> studyExperiments(const StudyRun& run);

// How often all of them announce what they measure.
int countSteps(const std::vector<StudyExperiment>& experiments);

// Runs them one after the other, so that nothing disturbs their clocks, and picks the headlines. Facts are
// what studyFacts() says, and how long it took.
Study runStudy(StudyRun& run, const std::vector<StudyExperiment>& experiments);

}  // namespace shprt
