// Which points are inside other solid geometry, where nobody sees them.
//
// Hardly a ray from such a point sees the sky, and many meet backs. That is not enough: so it is for the
// ceiling above a lamp that has no back of its own, and the room's light is on that ceiling. The others tell:
// from inside a solid they meet fronts that are in there too, such as the floor on which a box stands, or the
// top of the box below. So all points that are likely to be buried count as buried, until one is found to see
// fronts that are not; that is taken back, and what sees it judged anew, as long as anything changes. Points
// that meet fewer backs, where several covered surfaces meet, follow what they see.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/transfer/hit_store.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

// Rays that tell whether a point is buried: with 64 one seed in five gets the line where surfaces cross
// wrong, with 256 one in ten.
inline constexpr int kBurialRays = 512;
// Of those rays, whatever the seed of the bake: what is buried is a fact of the scene, and one vertex that one
// bake takes for buried and another does not can make all of their difference.
inline constexpr std::uint64_t kBurialSeed = 1;

// How many of a point's rays end where.
struct RayEnds {
  std::size_t sky = 0, fronts = 0, backs = 0;

  std::size_t count() const { return sky + fronts + backs; }
  // One ray in 64 may have slipped through where surfaces cross; of thousands, some do.
  static bool isNothing(std::size_t rays, std::size_t count) { return 64 * rays <= count; }
  bool seesNoSky() const { return isNothing(sky, count()); }
  // Whether the point may be buried: where floor, wall and box meet under a box, both of the others fill most
  // of each hemisphere, but never all.
  bool mayBeBuried() const { return seesNoSky() && 8 * backs > count(); }
  // The same from few rays: half as many backs leave it open.
  bool mightBeBuried() const { return seesNoSky() && 16 * backs > count(); }
  // At its foot, a wall that goes on inside a box has half of its hemisphere filled by the floor in there;
  // two fifths of backs leave room for sampling error.
  bool isLikelyBuried() const { return seesNoSky() && 5 * backs > 2 * count(); }
};

class BuriedSearch {
 public:
  // Adds a point that may be buried, and the fronts that its rays meet. Each point once, in any order: the
  // answer is the same.
  void add(std::size_t point, const RayEnds& ends, std::span<const CompactHit> fronts);
  void add(BuriedSearch&& other);

  // Per point, 0 or 1. A point is buried when at most one in 64 of its rays, which may have slipped through,
  // meet fronts without a buried corner.
  std::vector<std::uint8_t> find(const SurfaceTopology& topology) const;

 private:
  struct Seen {
    std::uint32_t triangle, rays;
  };
  struct Candidate {
    std::uint32_t point;
    bool isLikely;
    std::size_t allowed;  // rays
    std::vector<Seen> fronts;
  };
  static bool seesOpenFronts(const Candidate& candidate, const SurfaceTopology& topology,
                             std::span<const std::uint8_t> isBuried);

  std::vector<Candidate> candidates_;
};

}  // namespace shprt
