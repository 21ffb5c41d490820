#include "shprt/transfer/effect_cost.h"

#include <algorithm>

#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

// The pilot's vertices lie far apart, a bake's side by side: its rays find more in the cache. Measured over
// the scenes of docs/effects.md.
constexpr double kBakeOverPilot = 0.8;
// One bounce of one kept hit: finding its three vertices, and each of their floats.
constexpr double kSecondsPerHit = 8e-9, kSecondsPerHitFloat = 0.1e-9;
constexpr double kBytesPerHit = 8;

}  // namespace

BakeSeconds predictSeconds(const BouncePilot& pilot, const BakeWork& work) {
  const double threads = threadCount();
  const auto all = static_cast<double>(work.points), below = static_cast<double>(work.pointsBelow);
  const double surroundings = all * pilot.secondsPerPoint;
  const double secondsOfTerms = work.rays * pilot.secondsPerTerm * coefficientCount(work.degree);
  BakeSeconds seconds;
  seconds.terms = below * secondsOfTerms / threads;
  seconds.shadows =
      (surroundings + below * work.rays * pilot.secondsPerShadowRay * kBakeOverPilot) / threads +
      seconds.terms;
  if (!work.interreflected) return seconds;

  const double nearestRays = all * work.rays * pilot.secondsPerNearestRay * kBakeOverPilot;
  const double hits = below * work.rays * pilot.hitShareOfCandidates;
  const double kept = std::min(1.0, static_cast<double>(work.hitMemory) / std::max(hits * kBytesPerHit, 1.0));
  const double floats = 3.0 * work.channels * coefficientCount(work.degree);
  const double perBounce = hits * (kSecondsPerHit + floats * kSecondsPerHitFloat) + (1 - kept) * nearestRays;
  const double whole = surroundings + nearestRays + all * secondsOfTerms + work.bounces * perBounce;
  seconds.bounces = std::max(0.0, whole / threads - seconds.shadows);
  return seconds;
}

std::uint64_t transferBytes(const AssetContent& content) {
  return content.vertices * static_cast<std::uint64_t>(content.channels) *
         static_cast<std::uint64_t>(coefficientCount(content.degree)) * (content.half ? 2 : 4);
}

std::uint64_t assetBytes(const AssetContent& content) {
  constexpr std::uint64_t kText = 4096, kTriple = 12, kPair = 8;
  const std::uint64_t perVertex =
      3 * kTriple + (content.textureCoordinates ? kPair : 0) + (content.emission ? kTriple : 0);
  return transferBytes(content) + content.vertices * perVertex + content.triangles * kTriple + kText;
}

}  // namespace shprt
