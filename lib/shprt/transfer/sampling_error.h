// From the errors of points to those of a bake: how large they are over all vertices, with what confidence,
// and the standard error of each vertex.
#pragma once

#include <vector>

#include "shprt/base/vec.h"
#include "shprt/coefficients/transfer_asset.h"
#include "shprt/scene/scene.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/light_rows.h"
#include "shprt/transfer/point_errors.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

// What a point counts in the RMS over vertices: the sum over its receivers' vertices of albedo^2, per
// channel.
std::vector<Vec3d> pointWeights(const Scene& scene, const SurfaceTopology& topology);

// Sum over channels of a point's squares, weighted; band errors of transfer alone.
double weightedSquare(const PointErrors& errors, const LightRows& squares, std::size_t point, Vec3d weight);

// 4^(3/2): the variance of a lattice falls as n^(-3/2) where straight edges of shadows are what it misses.
// Faster than that it falls for some scenes only; who counts on it is sometimes wrong.
inline constexpr double kSafeRatio = 8;

// Turns errors.squares into variances of the whole, by the ratio r of the points with as many rays, to a
// power of two: where few rays suffice, they are often few because little is seen, which is as if they were
// independent. r is kept between 4, independent rays, and kSafeRatio. Returns log4 of the r of all points
// together: variance falls as rays^-exponent.
double toVariances(std::span<const Vec3d> weights, PointErrors& errors);

// Fills error and errorBound of the statistics from variances. unshadowedSquare: squared norm of the
// unshadowed transfer. The bound is that of the mean of independent terms, one per point: mean + 1.645
// standard errors.
void measureSamplingError(const PointErrors& errors, std::span<const Vec3d> weights, double unshadowedSquare,
                          SamplingStatistics& statistics);

// Variances of points, per column, times rays^exponent, so that they can be compared whatever the rays; each
// the mean over the point and its neighbours along edges, twice, because those of a single point are known
// from one draw only. Exact points have and give nothing.
LightRows smoothVariances(const PointErrors& errors, const SurfaceTopology& topology, double exponent);

// Fills bake.error and bake.emissionError from smoothed variances, and the emission's error in statistics.
void storeErrors(const PointErrors& errors, const LightRows& variances, double exponent, const Scene& scene,
                 const SurfaceTopology& topology, Bake& bake);

// Fills raysPerVertex and verticesByRays.
void countRays(const PointErrors& errors, const Scene& scene, const SurfaceTopology& topology,
               SamplingStatistics& statistics);

}  // namespace shprt
