// The normal equations of vertex_fit.h, kept as the terms they are made of: a small matrix per triangle and
// a stencil per flap. Nothing is assembled; applying the terms costs little beside the rays.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/transfer/surface_samples.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

// Right-hand sides are solved this many at a time: what doubles a vector register or two hold.
inline constexpr std::size_t kFitLanes = 4;
using FitLanes = std::array<double, kFitLanes>;

// One entry per point (SurfaceTopology::pointIds) and lane.
using FitVector = std::vector<FitLanes>;

class FitEquations {
 public:
  FitEquations(const SurfaceTopology& topology, std::span<const SurfaceSample> samples, double alpha);

  std::size_t size() const { return diagonal_.size(); }
  // The matrix's diagonal; 0 for points that no sample's triangle has as a corner.
  std::span<const double> diagonal() const { return diagonal_; }
  // result = matrix * x.
  void apply(const FitVector& x, FitVector& result) const;

 private:
  struct Mass {  // sum over a triangle's samples of w b b^T, the upper half
    std::array<std::uint32_t, 3> points;
    double aa = 0, ab = 0, ac = 0, bb = 0, bc = 0, cc = 0;
  };
  struct Flap {  // the bracket is the sum of weights times values
    std::array<std::uint32_t, 4> points;
    std::array<double, 4> weights;
    double area;  // alpha times a third of the flap's
  };

  void addMasses(const SurfaceTopology& topology, std::span<const SurfaceSample> samples);
  void addFlaps(const SurfaceTopology& topology, std::span<const SurfaceSample> samples, double alpha);

  std::vector<Mass> masses_;
  std::vector<Flap> flaps_;
  std::vector<double> diagonal_;
};

}  // namespace shprt
