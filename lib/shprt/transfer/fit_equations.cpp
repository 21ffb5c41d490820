#include "shprt/transfer/fit_equations.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace shprt {
namespace {

// An edge of a triangle, as the points it joins (the smaller first), with the corner that faces it.
struct Edge {
  std::uint32_t low, high;
  std::uint32_t triangle;
  std::array<std::uint32_t, 3> vertices;  // at low, at high, facing

  auto key() const { return std::tuple(low, high); }
};

std::vector<Edge> sortedEdges(const SurfaceTopology& topology, std::span<const SurfaceSample> samples) {
  std::vector<Edge> edges;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (s > 0 && samples[s].triangle == samples[s - 1].triangle) continue;
    const Triangle& t = topology.triangles()[samples[s].triangle];
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (topology.pointIds()[a] > topology.pointIds()[b]) std::swap(a, b);
      edges.push_back(
          {topology.pointIds()[a], topology.pointIds()[b], samples[s].triangle, {a, b, t[(k + 2) % 3]}});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tuple(a.key(), a.triangle) < std::tuple(b.key(), b.triangle);
  });
  return edges;
}

// Where the corner facing an edge stands: its foot on the edge's line as a fraction of the edge, and its
// distance from it.
struct Apex {
  double foot, height;
};

Apex apexOver(const SurfaceTopology& topology, const Edge& edge) {
  const auto position = [&](std::size_t k) { return toDouble(topology.positions()[edge.vertices[k]]); };
  const Vec3d along = position(1) - position(0), offset = position(2) - position(0);
  const double foot = dot(offset, along) / dot(along, along);
  return {foot, length(offset - along * foot)};
}

}  // namespace

FitEquations::FitEquations(const SurfaceTopology& topology, std::span<const SurfaceSample> samples,
                           double alpha)
    : diagonal_(topology.pointCount()) {
  addMasses(topology, samples);
  if (alpha > 0) addFlaps(topology, samples, alpha);
}

void FitEquations::addMasses(const SurfaceTopology& topology, std::span<const SurfaceSample> samples) {
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const SurfaceSample& sample = samples[s];
    const auto& [a, b, c] = topology.triangles()[sample.triangle];
    if (s == 0 || sample.triangle != samples[s - 1].triangle)
      masses_.push_back({{topology.pointIds()[a], topology.pointIds()[b], topology.pointIds()[c]}});
    const double u = static_cast<double>(sample.u), v = static_cast<double>(sample.v), w = 1 - u - v;
    Mass& mass = masses_.back();
    mass.aa += sample.weight * w * w;
    mass.ab += sample.weight * w * u;
    mass.ac += sample.weight * w * v;
    mass.bb += sample.weight * u * u;
    mass.bc += sample.weight * u * v;
    mass.cc += sample.weight * v * v;
  }
  for (const Mass& mass : masses_) {
    diagonal_[mass.points[0]] += mass.aa;
    diagonal_[mass.points[1]] += mass.bb;
    diagonal_[mass.points[2]] += mass.cc;
  }
}

void FitEquations::addFlaps(const SurfaceTopology& topology, std::span<const SurfaceSample> samples,
                            double alpha) {
  const std::vector<Edge> edges = sortedEdges(topology, samples);
  for (auto first = edges.begin(); first != edges.end();) {
    const auto last =
        std::find_if(first, edges.end(), [&](const Edge& e) { return e.key() != first->key(); });
    // Borders have one triangle and no flap; where more than two meet, no two belong together.
    if (last - first == 2) {
      const Edge &one = *first, &two = *(first + 1);
      const Apex p = apexOver(topology, one), q = apexOver(topology, two);
      const double heights = p.height + q.height;
      if (heights > 0) {
        const double crossing = (q.height * p.foot + p.height * q.foot) / heights;
        const double scale = 1 / (std::abs(1 - crossing) + std::abs(crossing));
        const double area = triangleArea(topology, one.triangle) + triangleArea(topology, two.triangle);
        flaps_.push_back(
            {{one.low, one.high, topology.pointIds()[one.vertices[2]], topology.pointIds()[two.vertices[2]]},
             {scale * (1 - crossing), scale * crossing, -scale * q.height / heights,
              -scale * p.height / heights},
             alpha * area / 3});
      }
    }
    first = last;
  }
  for (const Flap& flap : flaps_)
    for (std::size_t k = 0; k < 4; ++k)
      diagonal_[flap.points[k]] += flap.area * flap.weights[k] * flap.weights[k];
}

void FitEquations::apply(const FitVector& x, FitVector& result) const {
  std::fill(result.begin(), result.end(), FitLanes{});
  for (const Mass& mass : masses_) {
    const FitLanes &a = x[mass.points[0]], &b = x[mass.points[1]], &c = x[mass.points[2]];
    FitLanes &ra = result[mass.points[0]], &rb = result[mass.points[1]], &rc = result[mass.points[2]];
    for (std::size_t lane = 0; lane < kFitLanes; ++lane) {
      ra[lane] += mass.aa * a[lane] + mass.ab * b[lane] + mass.ac * c[lane];
      rb[lane] += mass.ab * a[lane] + mass.bb * b[lane] + mass.bc * c[lane];
      rc[lane] += mass.ac * a[lane] + mass.bc * b[lane] + mass.cc * c[lane];
    }
  }
  for (const Flap& flap : flaps_) {
    FitLanes bracket{};
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t lane = 0; lane < kFitLanes; ++lane)
        bracket[lane] += flap.weights[k] * x[flap.points[k]][lane];
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t lane = 0; lane < kFitLanes; ++lane)
        result[flap.points[k]][lane] += flap.area * flap.weights[k] * bracket[lane];
  }
}

}  // namespace shprt
