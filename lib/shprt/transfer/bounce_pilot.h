// A pilot of a bake: a few hundred vertices, whose rays are followed through diffuse bounces, tell what
// shadows and each bounce will add, how sure that is, and how fast this machine traces this scene.
//
// Vertices are drawn evenly from the candidates, one from each of as many runs of equal length; area does
// not matter, as it does not in the error measure (docs/accuracy.md). Squared norms are estimated without
// bias as products of two independent halves of a vertex's paths, so the noise of few paths does not pass
// for light. Intervals are those of a normal mean over vertices at 95%; that the drawing is stratified only
// makes them wider than they need be. What no drawn vertex shows stays unknown: see BouncePilot::total.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/progress.h"
#include "shprt/transfer/prepared_scene.h"

namespace shprt {

struct Interval {
  double value = 0, low = 0, high = 0;
};

struct PilotOptions {
  int degree = 4;      // of the transfer whose norms are estimated
  int bandDegree = 8;  // of bandEnergy; from degree to kMaximumBakeDegree
  int vertices = 256;  // at most; all candidates where there are fewer
  int rays = 128;      // per vertex, rounded up to a multiple of 32
  std::uint64_t seed = 1;
};

// What light that bounced exactly k times adds.
struct PilotBounce {
  Interval norm;  // as BounceStatistics::norm
  std::array<Interval, 3>
      power;  // per channel: mean over receivers of irradiance/pi under a sky of radiance 1
};

struct BouncePilot {
  static constexpr int kBounces = 12;

  std::size_t vertices = 0;         // drawn
  std::uint64_t paths = 0;          // from them
  std::uint64_t met = 0;            // paths that met a reflecting surface
  double hitShareOfCandidates = 0;  // rays of candidates that end on any surface, as a share
  Interval visibility;  // mean over receivers of the visible share of the cosine-weighted hemisphere
  Interval shadow;      // norm of what shadows take away, in the measure
  std::vector<PilotBounce> bounces;  // [0] for light that bounced once; kBounces of them
  // All bounces together, those beyond kBounces included. Where no path met anything, `high` is what that
  // leaves possible: at 95%, at most 3 in n vertices can differ from the n drawn.
  Interval total;
  std::array<double, 3> power{};  // of all bounces, as PilotBounce::power
  // RMS over receivers and channels of what bounces add to a channel beyond the mean of the three, in the
  // measure.
  Interval colourBleed;
  double ratio =
      0;  // of successive bounces' power, as late as enough paths show it; below 1, 0 without bounces
  int sureBounces = 0;  // up to which power is taken as measured, beyond by the ratio
  // Per band: mean over receivers of the squared norm of the shadowed transfer per unit albedo, without bias,
  // but for sampling not below 0.
  std::vector<double> bandEnergy;
  std::array<double, 3> emission{};  // mean over receivers of the irradiance/pi from the scene's own lights
  double emissionReach = 0;          // share of receivers that such light reached

  // Seconds of one thread, for CostModel (effect_cost.h).
  double secondsPerPoint = 0;       // before its rays: surroundings and horizon
  double secondsPerShadowRay = 0;   // any hit
  double secondsPerNearestRay = 0;  // nearest hit
  double secondsPerTerm = 0;        // one coefficient of one ray
  double seconds = 0;               // the pilot itself, of the clock on the wall

  // What bounces beyond the first k would add, in the measure: total.high shared out as power is.
  double remainderAfter(int k) const;
  // The least number of bounces after which the remainder is at most `error`.
  int bouncesFor(double error) const;
};

// candidates: the vertices among which to draw, increasing. receivers: how many vertices the means are over;
// those that are no candidates are known to see everything, and to get neither shadow nor bounce. The same
// bits, seconds aside, for any number of threads.
BouncePilot pilotBounces(const PreparedScene& prepared, std::span<const std::uint32_t> candidates,
                         std::size_t receivers, const PilotOptions& options,
                         const ProgressCallback& progress = {});

}  // namespace shprt
