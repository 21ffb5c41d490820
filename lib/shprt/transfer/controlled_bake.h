// Bakes that know how uncertain they are, and take as many rays as an error or a time asks for.
//
// A first pass gives every point the same few rays. What it finds decides where more are worth most
// (ray_allocation.h), and a pass of fresh rays follows; where it takes many times as many, one between the
// two makes the prediction sharper. No pass uses rays of another, so that the last is unbiased and its
// errors are honest (point_errors.h). Where the bound still is above what was asked for, another pass with
// more rays follows.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "shprt/base/progress.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/point_errors.h"
#include "shprt/transfer/prepared_scene.h"
#include "shprt/transfer/ray_plan.h"

namespace shprt {

struct SamplingControl {
  PointSet points = PointSet::kLattice;
  std::uint64_t seed = 1;
  int degree = 4;
  // What decides on the rays: a number for all points; or the error to reach, and the seconds that the
  // passes together may take (the error is then the least that fits), or either. Each above 0.
  std::optional<int> rays = {};
  std::optional<double> error = {};
  std::optional<double> seconds = {};
};

struct SamplingPassInput {
  const RayPlan& plan;
  std::uint64_t seed;
  PointErrors& errors;                 // to be filled
  std::vector<std::uint8_t>& burials;  // as ShadowedOptions: the first pass finds them for all
};

// Bakes once.
using SamplingPassFunction = std::function<Bake(const SamplingPassInput&, const ProgressCallback&)>;

// The bake of the last pass, with its errors, and what they are in statistics.sampling; statistics.rays and
// traceSeconds are those of all passes together. An error below what the most rays give (RayPlan) is missed:
// statistics tell. With seconds, which pass is the last and what rays it takes depend on how fast the machine
// is; all else has the same bits for any number of threads.
Bake bakeControlled(const PreparedScene& prepared, const SamplingControl& control,
                    const SamplingPassFunction& pass, const ProgressCallback& progress);

}  // namespace shprt
