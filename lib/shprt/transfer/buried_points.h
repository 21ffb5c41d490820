// Points inside other solid geometry: they see nothing but backs, and the black that they would get spreads
// through interpolation over triangles that come out of the solid.
//
// What they would receive is nobody's to see, so they take it from their surroundings: the harmonic
// extension, in which each buried point has the mean of its neighbours along mesh edges. Only points of the
// same smooth surface are neighbours: hard edges are not crossed, seams are. Where a whole surface is buried
// there is nothing to take, and its points keep what they have.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/transfer/light_rows.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

class BuriedPoints {
 public:
  BuriedPoints() = default;  // none
  // isBuried: per point, 0 or 1.
  BuriedPoints(const SurfaceTopology& topology, std::span<const std::uint8_t> isBuried);

  bool none() const { return order_.empty(); }

  // From now on rows are only those of the points that are filled or taken from: returns these points, in the
  // order of their rows.
  std::vector<std::uint32_t> renumber();

  // Fills the rows (one per point) of buried points from the others, column by column: linear in them. By
  // repeated averaging in a fixed order until no value moves by more than 1e-3 of the largest.
  void fill(LightRows& rows) const;

 private:
  struct Filled {
    std::uint32_t point;
    std::size_t firstNeighbour, settledEnd, end;  // into neighbours_: those filled earlier come first
  };
  float average(LightRows& rows, const Filled& filled, std::size_t end, std::vector<double>& sums) const;

  std::vector<Filled> order_;  // nearest to the surface that is not buried first
  std::vector<std::uint32_t> neighbours_;
};

}  // namespace shprt
