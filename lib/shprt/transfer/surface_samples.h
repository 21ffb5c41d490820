// Points spread over the triangles of a scene's receivers, at which transfer is measured before it is fitted
// to the vertices.
//
// Based on: Basu and Owen 2015 (the triangular van der Corput sequence: the base-4 digits of an index choose
// among the four congruent parts of a triangle, again and again), with the digits scrambled and the last part
// sampled at random.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/scene/scene.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

struct SurfaceSample {
  std::uint32_t triangle = 0;
  float u = 0, v = 0;  // barycentrics of corners 1 and 2
  double weight = 0;   // the area it stands for, in the scene frame
};

// What was measured at samples: a row of floats for each, whatever its entries mean (coefficients, channels).
struct SampleValues {
  std::size_t rows = 0;
  std::vector<float> values;  // [sample][row]

  std::span<const float> at(std::size_t sample) const {
    return std::span(values).subspan(sample * rows, rows);
  }
};

struct SampleOptions {
  double perTriangle = 8;  // on average; shared out by area. More than 0
  int minimum = 4;         // at least 1 for every triangle, however small
  std::uint64_t seed = 1;
};

// Samples grouped by triangle, in increasing order; a triangle's share its area equally. Each is uniform over
// its triangle, and the first 4^k of a triangle fall one into each of its 4^k congruent parts, for every k.
// Triangles whose corners belong to blockers have none.
std::vector<SurfaceSample> sampleSurface(const Scene& scene, const SurfaceTopology& topology,
                                         const SampleOptions& options);

// Takes the samples that `which` lists in increasing order, and their values, out.
void removeSamples(std::span<const std::uint32_t> which, std::vector<SurfaceSample>& samples,
                   SampleValues& values);

// Value at barycentrics u, v of what the corners have.
inline Vec3d interpolate(const Vec3d (&corners)[3], double u, double v) {
  return corners[0] * (1 - u - v) + corners[1] * u + corners[2] * v;
}

// Area of a triangle in the scene frame.
double triangleArea(const SurfaceTopology& topology, std::uint32_t triangle);

}  // namespace shprt
