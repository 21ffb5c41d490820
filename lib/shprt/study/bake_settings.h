// What can be chosen for an asset, and how `shprt bake` is asked for just that.
#pragma once

#include <string>

#include "shprt/coefficients/asset_file.h"
#include "shprt/study/study_run.h"
#include "shprt/transfer/planned_bake.h"

namespace shprt {

struct BakeSettings {
  BakeRequest request;
  WriteAssetOptions storage;
};

// The options: "--model shadowed --degree 4 --rays 64 --half". They name the model, so nothing is left to a
// plan.
std::string optionsOf(const BakeSettings& settings);

// The whole command line, to be run where the study was.
std::string bakeCommand(const StudyRun& run, const BakeSettings& settings, const std::string& output);

}  // namespace shprt
