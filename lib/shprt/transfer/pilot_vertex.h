// The paths of one vertex of the pilot, and what they add up to.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/sampling/hemisphere_set.h"
#include "shprt/transfer/bounce_pilot.h"
#include "shprt/transfer/light_path.h"
#include "shprt/transfer/local_horizon.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {

struct PilotSeconds {
  double point = 0, shadowRays = 0, nearestRays = 0, terms = 0;
};

// Products are between the sums of the vertex's two halves, summed over coefficients.
struct PilotVertex {
  // Index k: light that bounced k times (0 unused); the last, kBounces + 1: more often.
  std::array<double, BouncePilot::kBounces + 2> products{};  // mean over channels
  std::array<Vec3d, BouncePilot::kBounces + 2> power{};
  std::array<std::uint32_t, BouncePilot::kBounces + 2> arrived{};  // paths
  double totalProduct = 0, colourProduct = 0;
  double shadowProduct = 0;  // of what shadows take away
  std::vector<double> bandProducts;
  double visible = 0;  // share of paths
  std::uint32_t met = 0;
  Vec3d emission;
  PilotSeconds seconds;
};

// One per thread at a time; buffers are kept from vertex to vertex.
class PilotTracer {
 public:
  PilotTracer(const PreparedScene& prepared, const HemisphereSet& half, const PilotOptions& options);

  PilotVertex trace(std::uint32_t vertex);

 private:
  // Of one half: coefficients of what bounced k times, per channel; [bounce][channel][coefficient].
  using Sums = std::vector<double>;

  void traceHalf(std::uint32_t vertex, int half, const IgnoredTriangles& ignored, PilotVertex& result);
  void followPath(std::uint32_t vertex, int half, std::size_t ray, const ReflectingPoint& first,
                  PilotVertex& result);
  void sumDirect(int half, double share);
  void multiplyHalves(PilotVertex& result) const;

  const PreparedScene& prepared_;
  const HemisphereSet& lattice_;  // of half the rays
  const PilotOptions& options_;
  UnshadowedTransfer unshadowed_;
  PathFollower follower_;
  LocalHorizon horizon_;
  std::vector<float> x_, y_, z_, weights_;
  std::vector<double> direct_[2], analytic_, basis_;
  Sums bounced_[2];
};

}  // namespace shprt
