// What was studied, with which settings, and on what machine.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "shprt/study/study_run.h"

namespace shprt {

// Labels and values for people: scene, vertices, triangles, light, model planned, settings, processor, cores
// and threads, version, date (UTC).
std::vector<std::pair<std::string, std::string>> studyFacts(const StudyRun& run);

// "model name" of /proc/cpuinfo; "unknown" where there is none.
std::string processorName();

}  // namespace shprt
