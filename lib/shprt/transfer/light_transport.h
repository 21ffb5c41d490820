// Light between the surfaces of a scene: what every point receives, bounce after bounce.
//
// With E_k the irradiance/pi that arrives at a point after k bounces, per unit of each lighting coefficient,
// E_0 is the shadowed transfer, and E_{k+1} = K E_k, where K takes the mean over a point's rays of albedo
// times E where they end on fronts. The rays are those that E_0 was traced with, so K is a sparse matrix that
// costs no further rays. Inside triangles albedo * E is interpolated from the corners, with textures E alone.
// Based on: Sloan, Kautz and Snyder 2002 (interreflections by passes over the same rays).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "shprt/base/progress.h"
#include "shprt/scene/scene.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/bounce_series.h"
#include "shprt/transfer/buried_points.h"
#include "shprt/transfer/direct_transfer.h"
#include "shprt/transfer/hit_store.h"
#include "shprt/transfer/hit_tracer.h"
#include "shprt/transfer/light_rows.h"
#include "shprt/transfer/prepared_scene.h"
#include "shprt/transfer/ray_plan.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

class LightTransport {
 public:
  // The arguments must outlive it; it counts rays, hits and memory in statistics.
  LightTransport(const PreparedScene& prepared, const InterreflectedOptions& options,
                 BakeStatistics& statistics);

  // E_0 of all points.
  void trace(const ProgressCallback& progress);
  // E_{k+1} from E_k.
  void bounce();

  const LightLayout& layout() const { return layout_; }
  const LightRows& light() const { return light_; }  // E_k, a row per point
  LightRows takeLight() && { return std::move(light_); }
  // Fills options.pointErrors. received: all that points receive, over all bounces.
  void measureErrors(const LightRows& received);
  // Of E_k per band; transfer over the norm of the unshadowed transfer.
  std::vector<BandNorm> norms() const;
  // Per band, a bound on the ratio of any two successive bounces at the point where it is largest.
  std::vector<double> largestRatios() const;

 private:
  struct BlockCounts;
  HitTracer makeTracer(const RayPlan& plan, std::uint64_t seed) const;
  bool isTraced(std::size_t point) const { return bounces_ || receivers_[point] > 0; }
  void measureDirect(DirectTransfer& direct, const HemisphereTracer& rays, std::size_t point,
                     const std::array<std::span<const CompactHit>, 4>& hits);
  template <class Visit>
  std::uint64_t forHitsOf(std::size_t begin, std::size_t end, const Visit& visit) const;

  const PreparedScene& prepared_;
  const Scene& scene_;
  const SurfaceTopology& topology_;
  const InterreflectedOptions& options_;
  BakeStatistics& statistics_;
  bool bounces_;  // whether any will be asked for; else only receivers are traced
  LightLayout layout_;
  std::optional<RayPlan> samePlan_;  // where options have none
  const RayPlan& plan_;
  RayPlan burialPlan_;
  HitStore hits_;
  std::vector<std::uint32_t> receivers_;  // per point, render vertices of it that are baked
  BuriedPoints buried_;
  LightRows light_;    // per point
  LightRows sources_;  // per render vertex, what it sends back; no rows without bounces
  // Of E_0, three contrasts between quarters of rays per point (point_errors.h): coefficients that serve all
  // channels, and emission. No rows without errors.
  LightRows contrasts_;
  double largestFrontShare_ = 0;
};

}  // namespace shprt
