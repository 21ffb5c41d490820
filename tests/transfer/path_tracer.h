// Interreflected transfer by brute force: the truth that baking is held against, and built from nothing that
// baking uses. Plain random walks between exact facets, every ray its own random number, Embree asked
// directly, positions and sums in double.
//
// What it computes, for a point x with normal n: the mean over cosine-distributed directions w of what
// arrives along w, where a ray that misses brings y_lm(its own direction), and a ray that meets the front of
// a facet brings albedo times the same mean taken there, around the facet's own normal (not an interpolated
// one: facets are the geometry). Backs bring nothing, unless a facet with the opposite front coincides.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/scene/scene.h"

namespace shprt::test {

struct PathOptions {
  int degree = 4;
  int paths = 4096;
  std::uint64_t seed = 1;
  // Bounces between surfaces at most, counted as InterreflectedOptions does. Without: walks end by Russian
  // roulette, which keeps the mean that of endlessly many bounces.
  std::optional<int> bounces = {};
};

// Per unit albedo of the point itself. Standard errors are those of the means, measured from the walks.
struct PathEstimate {
  std::vector<Vec3d> transfer, transferError;  // per coefficient, three channels
  Vec3d emission, emissionError;               // what the scene's own lights bring, over pi
};

class PathTracer {
 public:
  explicit PathTracer(const Scene& scene);  // which must outlive it
  ~PathTracer();

  // At a render vertex: starts a hair above it along its normal, and over one of its triangles, each as
  // likely as any other (far less to the side than up, so that the triangle itself hides nothing). Triangles
  // that are inside something there, whose starts see no sky and mostly backs (a face of the solid they are
  // in may coincide with the front of another), are left out where others are not: on the line where a box
  // stands on a floor, the surface that anyone sees is the one outside.
  PathEstimate atVertex(std::uint32_t vertex, const PathOptions& options) const;
  // How many of a vertex's triangles are inside something there, as a share: 1 where nobody can see it,
  // something between on the line where surfaces cross or stand on each other.
  double buriedShare(std::uint32_t vertex) const;

  // At a point inside a triangle, around the triangle's normal (on its front).
  PathEstimate inTriangle(std::uint32_t triangle, double u, double v, const PathOptions& options) const;

 private:
  struct Hit;
  struct Impl;

  PathEstimate estimate(const std::vector<Vec3d>& starts, Vec3d normal, std::uint64_t index,
                        const PathOptions& options) const;
  std::vector<Vec3d> startsAt(std::uint32_t vertex) const;
  bool isInside(Vec3d start, Vec3d normal) const;
  std::optional<Hit> nearest(Vec3d origin, Vec3d direction) const;

  const Scene& scene_;
  std::vector<Vec3d> positions_;  // about the centre, the largest extent between 1 and 2
  std::vector<Vec3d> fronts_;     // per triangle: the unit normal on its front
  std::vector<std::vector<std::uint32_t>> trianglesAt_;
  std::map<std::array<std::array<float, 3>, 3>, std::vector<std::uint32_t>> coincident_;  // by corners
  std::unique_ptr<Impl> impl_;
};

}  // namespace shprt::test
