// What shprt bake did, for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "bake_job.h"
#include "output.h"

namespace shprt {

// metadata: of the asset that was made of the outcome.
void printOutcome(const Console& console, const BakeOptions& options, const BakeOutcome& outcome,
                  const AssetMetadata& metadata);

// assets: the files written; metadata of the asset of all receivers.
Json figuresOf(const BakeOptions& options, const BakeOutcome& outcome, const AssetMetadata& metadata,
               const std::vector<std::string>& assets, double seconds);

}  // namespace shprt
