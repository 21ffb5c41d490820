// The transport models: mesh in, transfer coefficients out.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shprt/base/progress.h"
#include "shprt/coefficients/transfer_asset.h"
#include "shprt/mesh/mesh.h"

namespace shprt {

struct BakeStatistics {
  std::uint64_t rays = 0;         // rays traced
  double buildSeconds = 0;        // acceleration structure
  double traceSeconds = 0;        // rays and accumulation
  std::uint64_t embreeBytes = 0;  // most memory that Embree held at once
  double meanVisibility = 1;      // mean over vertices of the visible share of the cosine-weighted hemisphere
  std::uint64_t fullyVisible = 0;  // vertices
  std::uint64_t fullyHidden = 0;
  std::uint64_t samplePoints = 0;  // distinct (position, normal) that were baked
};

struct Bake {
  TransferCoefficients transfer;
  BakeStatistics statistics;
};

// Transfer without any shadow, from the normal alone: (albedo/pi) A_l y_lm(n). Exact to float.
// albedo has one entry per vertex, linear Rec.709.
Bake bakeUnshadowed(const Mesh& mesh, std::span<const Vec3f> albedo, int degree);

struct ShadowedOptions {
  int degree = 4;
  int rays = 256;  // per vertex
  std::uint64_t seed = 1;
};

// Transfer with shadows cast by the mesh on itself, by cosine-distributed rays (see shadowed.cpp).
Bake bakeShadowed(const Mesh& mesh, std::span<const Vec3f> albedo, const ShadowedOptions& options,
                  const ProgressCallback& progress = {});

}  // namespace shprt
