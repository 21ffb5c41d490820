// What every point of a scene receives once light has bounced between its surfaces: the sum over bounces
// (light_transport.h), and how that sum is brought to its end.
#pragma once

#include "shprt/base/progress.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/light_rows.h"
#include "shprt/transfer/prepared_scene.h"

namespace shprt {

struct LightSolution {
  LightLayout layout;
  LightRows received;    // per point, irradiance/pi per unit of each lighting coefficient, all bounces
  LightRows lastBounce;  // what of that the last bounce brought
};

// Fills all of statistics but buildSeconds. Points that only blockers have receive nothing where bounces = 0.
LightSolution solveLight(const PreparedScene& prepared, const InterreflectedOptions& options,
                         const ProgressCallback& progress, BakeStatistics& statistics);

}  // namespace shprt
