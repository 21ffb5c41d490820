// Bakes of a study's scene as the command line makes them: what they cost, and the asset they become.
#pragma once

#include <cstdint>

#include "shprt/coefficients/asset_file.h"
#include "shprt/coefficients/transfer_asset.h"
#include "shprt/study/study_run.h"
#include "shprt/transfer/planned_bake.h"

namespace shprt {

struct StudyBake {
  TransferAsset asset;  // of the receivers
  double seconds = 0;   // of rays and bounces, and of the acceleration structure where rays are traced
  SamplingStatistics sampling;
};

// Throws what bakeRequested() throws, and what the run's progress throws.
StudyBake bakeForStudy(const StudyRun& run, const BakeRequest& request);

// An asset through a file and back.
struct StoredAsset {
  TransferAsset asset;  // as read
  std::uint64_t bytes = 0;
  double seconds = 0;  // of writing
};

// Writes to the system's folder for temporary files and removes the file again. Throws Error when that cannot
// be written, or when halves cannot hold a value.
StoredAsset storeAndRead(const TransferAsset& asset, const WriteAssetOptions& options);

// Seconds to relight all its vertices under the light, or, without one (nullptr), under any of the transfer's
// degree: the least of several goes.
double relightSeconds(const TransferAsset& asset, const LightCoefficients* light);

}  // namespace shprt
