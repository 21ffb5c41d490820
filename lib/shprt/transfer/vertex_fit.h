// Vertex values whose linear interpolation over the triangles comes nearest to values sampled on them.
//
// Based on: Kavan, Bargteil and Sloan 2011, whose idea it is to fit vertices by least squares with a
// regulariser against jumps of the gradient between triangles. The functional here is
//
//   sum_s w_s |sum_k b_k(s) c_k - T_s|^2  +  alpha sum_f a_f (e_f - (h2 p + h1 q) / (h1 + h2))^2
//
// The first sum is over samples: w_s is the area a sample stands for, b_k(s) are its barycentrics, c_k the
// unknowns. The second is over flaps, pairs of triangles with a common edge, unfolded into a plane: p and q
// are the values at the two corners that face each other, h1 and h2 those corners' distances from the common
// edge, e_f is the interpolated value where the straight line between the corners crosses the edge, a_f a
// third of the flap's area. The bracket is the jump of the gradient across the edge times
// h1 h2 / (h1 + h2): it vanishes for linear values and has the unit of the values themselves. Where that line
// passes beside the edge, e_f is extrapolated, and the bracket is divided by the sum of e_f's weights without
// their signs, so that no weight exceeds 1 and slivers count by their area. alpha is therefore a pure number:
// as much area counts as much in either sum.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shprt/transfer/surface_samples.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

struct FitOptions {
  double alpha = 0.01;      // not negative
  double tolerance = 1e-6;  // see VertexFit::residual; positive
  int maximumIterations = 1000;
};

struct VertexFit {
  std::vector<float> values;  // [row][vertex]
  // What is left of the normal equations, largest over rows, relative to the largest right-hand side; both
  // in the norm that weighs with the inverse of the matrix's diagonal. Measured on the final values, in
  // double.
  double residual = 0;
  bool converged = true;  // whether every row came below the tolerance within the iterations allowed
  int iterations = 0;     // of conjugate gradients, most over rows
  // RMS over area of the 2-norm over rows of what is left between the samples and the fit.
  double sampleDistance = 0;
  std::uint64_t fittedVertices = 0;  // that some sample reaches
};

// One unknown for each point (distinct position and normal), so hard edges stay hard and seams stay closed;
// flaps join triangles that share two points. Each row is fitted by itself. samples are as sampleSurface
// gives them, grouped by triangle; start holds values.rows rows of one entry per vertex. Vertices that no
// sample reaches keep their start; where the samples and alpha = 0 leave a choice, the result stays near it.
// Same bits for any number of threads.
VertexFit fitToSamples(const SurfaceTopology& topology, std::span<const SurfaceSample> samples,
                       const SampleValues& values, std::span<const float> start, const FitOptions& options);

}  // namespace shprt
