#include "shprt/transfer/buried_search.h"

#include <algorithm>
#include <iterator>

namespace shprt {

void BuriedSearch::add(std::size_t point, const RayEnds& ends, std::span<const CompactHit> fronts) {
  std::vector<std::uint32_t> triangles;
  for (const CompactHit& hit : fronts) triangles.push_back(hit.triangle);
  std::sort(triangles.begin(), triangles.end());
  Candidate candidate{static_cast<std::uint32_t>(point), ends.isLikelyBuried(), ends.count() / 64, {}};
  for (const std::uint32_t triangle : triangles) {
    if (candidate.fronts.empty() || candidate.fronts.back().triangle != triangle)
      candidate.fronts.push_back({triangle, 0});
    ++candidate.fronts.back().rays;
  }
  candidates_.push_back(std::move(candidate));
}

void BuriedSearch::add(BuriedSearch&& other) {
  std::move(other.candidates_.begin(), other.candidates_.end(), std::back_inserter(candidates_));
}

bool BuriedSearch::seesOpenFronts(const Candidate& candidate, const SurfaceTopology& topology,
                                  std::span<const std::uint8_t> isBuried) {
  std::size_t open = 0;
  for (const Seen& seen : candidate.fronts) {
    const Triangle& corners = topology.triangles()[seen.triangle];
    const bool anyBuried = std::any_of(corners.begin(), corners.end(), [&](std::uint32_t vertex) {
      return isBuried[topology.pointIds()[vertex]] != 0;
    });
    if (!anyBuried) open += seen.rays;
  }
  return open > candidate.allowed;
}

std::vector<std::uint8_t> BuriedSearch::find(const SurfaceTopology& topology) const {
  std::vector<std::uint8_t> isBuried(topology.pointCount());
  for (const Candidate& candidate : candidates_) isBuried[candidate.point] = candidate.isLikely;
  // Points are only ever taken back, so this ends, and what remains does not depend on the order.
  for (bool changed = true; changed;) {
    changed = false;
    for (const Candidate& candidate : candidates_) {
      if (!isBuried[candidate.point] || !seesOpenFronts(candidate, topology, isBuried)) continue;
      isBuried[candidate.point] = 0;
      changed = true;
    }
  }
  std::vector<std::uint8_t> result = isBuried;
  for (const Candidate& candidate : candidates_)
    if (!candidate.isLikely && !seesOpenFronts(candidate, topology, isBuried)) result[candidate.point] = 1;
  return result;
}

}  // namespace shprt
