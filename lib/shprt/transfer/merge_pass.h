// Two passes over the same scene with independent rays, made one.
#pragma once

#include "shprt/transfer/bake.h"
#include "shprt/transfer/point_errors.h"

namespace shprt {

// Adds an earlier pass to `bake` and its errors: their mean, weighted by how certain each is as a whole,
// which leaves every vertex unbiased even where the rays of the second were chosen by what the first saw.
// Errors are those of that mean, and its rays both passes'. The rest of the statistics stays that of `bake`.
// error: RMS of each, in any unit; weights: pointWeights.
void mergePass(const Bake& before, const PointErrors& errorsBefore, double errorBefore, Bake& bake,
               PointErrors& errors, double error);

}  // namespace shprt
