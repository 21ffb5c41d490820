// Where rays are worth most: how many each point takes, so that the error over all vertices is reached with
// the fewest.
//
// A point whose variance is V (m/n)^p after n rays, and that counts w, takes n so that every further ray
// gains the same at every point: n^(p+1) proportional to w p V m^p (Neyman allocation, for p = 1 in
// proportion to the standard deviation). V and p come from an earlier pass, and from a point's surroundings
// more than from itself: half from its neighbours, half from a wider neighbourhood, because where little is
// seen few points have met any of it. A hundredth of the mean is added, because a pass that found nothing
// does not say that there is nothing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/transfer/point_errors.h"
#include "shprt/transfer/sampling_error.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

struct RayAllocation {
  std::vector<std::uint8_t> levels;  // RayPlan's
  double rays = 0;                   // of points that are not exact
  double error = 0;                  // predicted, in the units of SamplingStatistics
};

class RayAllocator {
 public:
  // errors: of the pass before. mostExponent: p is at most that.
  RayAllocator(const PointErrors& errors, const SurfaceTopology& topology, std::span<const Vec3d> weights,
               double unshadowedSquare, double mostExponent);

  // The fewest rays whose predicted error is at most `error`; the most there are, where none is.
  RayAllocation forError(double error) const;
  // As many as there are among `rays`, and no more; but at least the least level everywhere.
  RayAllocation forRays(double rays) const;

 private:
  struct Point {
    bool isExact = true;
    float exponent = 1;          // p
    float logVariance = 0;       // log2 of w V, its share of the squared error, had it one ray
    float level = 0, slope = 0;  // the ideal level is level + slope * price
  };
  RayAllocation allocate(double price) const;
  template <class Enough>
  RayAllocation search(const Enough& isEnough) const;

  std::vector<Point> points_;
};

}  // namespace shprt
