#include "shprt/transfer/bounce_pilot.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <mutex>

#include "shprt/base/parallel.h"
#include "shprt/sampling/fibonacci_hemisphere.h"
#include "shprt/sampling/random.h"
#include "shprt/transfer/material_evidence.h"
#include "shprt/transfer/pilot_vertex.h"
#include "shprt/transfer/stopwatch.h"

namespace shprt {
namespace {

constexpr double kNormalQuantile = 1.96;  // two-sided 95%
// -log(0.05): what happens to a share 3/n of many shows among n drawn with a probability of 95%.
constexpr double kUnseenEvents = 3;
// Paths that a ratio of bounces needs behind it to be believed.
constexpr std::uint64_t kEnoughPaths = 200;
constexpr double kLargestRatio = 0.999;

// The mean over receivers of a quantity that is known for the drawn vertices and 0 off the candidates.
template <typename Quantity>
Interval meanOf(const std::vector<PilotVertex>& drawn, double candidateShare, const Quantity& quantity) {
  const auto count = static_cast<double>(drawn.size());
  if (drawn.empty()) return {};
  double sum = 0, squares = 0;
  for (const PilotVertex& vertex : drawn) sum += quantity(vertex);
  const double mean = sum / count;
  for (const PilotVertex& vertex : drawn) squares += (quantity(vertex) - mean) * (quantity(vertex) - mean);
  const double deviation =
      drawn.size() > 1 ? kNormalQuantile * std::sqrt(squares / (count - 1) / count) : std::fabs(mean);
  return {candidateShare * mean, candidateShare * (mean - deviation), candidateShare * (mean + deviation)};
}

Interval normOf(Interval square, double unshadowedNorm) {
  const auto root = [&](double a) { return std::sqrt(std::max(a, 0.0)) / unshadowedNorm; };
  return {root(square.value), root(square.low), root(square.high)};
}

std::vector<std::uint32_t> draw(std::span<const std::uint32_t> candidates, int count, std::uint64_t seed) {
  const std::size_t drawn = std::min(candidates.size(), static_cast<std::size_t>(count));
  std::vector<std::uint32_t> vertices(drawn);
  for (std::size_t i = 0; i < drawn; ++i) {
    const std::size_t begin = i * candidates.size() / drawn, end = (i + 1) * candidates.size() / drawn;
    vertices[i] = candidates[begin + hashCounter(seed, i) % (end - begin)];
  }
  return vertices;
}

void measureBounces(const std::vector<PilotVertex>& drawn, double share, double unshadowedNorm,
                    BouncePilot& pilot) {
  for (std::size_t k = 1; k <= BouncePilot::kBounces; ++k) {
    PilotBounce bounce;
    bounce.norm =
        normOf(meanOf(drawn, share, [&](const PilotVertex& v) { return v.products[k]; }), unshadowedNorm);
    bounce.power = {meanOf(drawn, share, [&](const PilotVertex& v) { return v.power[k].x; }),
                    meanOf(drawn, share, [&](const PilotVertex& v) { return v.power[k].y; }),
                    meanOf(drawn, share, [&](const PilotVertex& v) { return v.power[k].z; })};
    pilot.bounces.push_back(bounce);
  }
  pilot.shadow =
      normOf(meanOf(drawn, share, [](const PilotVertex& v) { return v.shadowProduct; }), unshadowedNorm);
  pilot.total =
      normOf(meanOf(drawn, share, [](const PilotVertex& v) { return v.totalProduct; }), unshadowedNorm);
  pilot.colourBleed =
      normOf(meanOf(drawn, share, [](const PilotVertex& v) { return v.colourProduct; }), unshadowedNorm);
  for (const PilotVertex& vertex : drawn)
    for (const Vec3d& power : vertex.power) {
      const double weight = share / static_cast<double>(drawn.size());
      pilot.power[0] += weight * power.x;
      pilot.power[1] += weight * power.y;
      pilot.power[2] += weight * power.z;
    }
}

double largestPower(const std::array<double, 3>& power) {
  return std::max({power[0], power[1], power[2]});
}

// Power of light that bounced more than k times, of the channel that has most in all.
double powerBeyond(const BouncePilot& pilot, int k) {
  const auto channel = static_cast<std::size_t>(std::max_element(pilot.power.begin(), pilot.power.end()) -
                                                pilot.power.begin());
  double beyond = pilot.power[channel];
  for (int j = 0; j < k; ++j) beyond -= pilot.bounces[static_cast<std::size_t>(j)].power[channel].value;
  return std::max(beyond, 0.0);
}

// The last number of bounces beyond which enough paths went on for their power to be believed.
int lastSure(const std::vector<PilotVertex>& drawn) {
  std::uint64_t beyond = 0;
  for (int k = BouncePilot::kBounces; k > 0; --k) {
    for (const PilotVertex& vertex : drawn) beyond += vertex.arrived[static_cast<std::size_t>(k) + 1];
    if (beyond >= kEnoughPaths) return k;
  }
  return 0;
}

}  // namespace

double BouncePilot::remainderAfter(int k) const {
  const double all = largestPower(power);
  if (all <= 0) return k == 0 ? total.high : 0;
  const int known = std::min(k, sureBounces);
  return total.high * powerBeyond(*this, known) / all * std::pow(ratio, k - known);
}

int BouncePilot::bouncesFor(double error) const {
  assert(error > 0);
  if (largestPower(power) <= 0) return total.high > error ? 1 : 0;
  int k = 0;
  while (k < sureBounces && remainderAfter(k) > error) ++k;
  const double remainder = remainderAfter(k);
  if (remainder <= error) return k;
  if (ratio <= 0) return k + 1;
  return k + static_cast<int>(std::ceil(std::log(error / remainder) / std::log(ratio)));
}

BouncePilot pilotBounces(const PreparedScene& prepared, std::span<const std::uint32_t> candidates,
                         std::size_t receivers, const PilotOptions& options,
                         const ProgressCallback& progress) {
  assert(candidates.size() <= receivers && receivers > 0 && options.vertices > 0 && options.rays > 0);
  assert(options.bandDegree >= options.degree && options.bandDegree <= kMaximumBakeDegree);
  const Stopwatch watch;
  const FibonacciHemisphere lattice((options.rays + 31) / 32 * 16, kRayPacketSize);
  const std::vector<std::uint32_t> vertices = draw(candidates, options.vertices, options.seed);
  std::vector<PilotVertex> drawn(vertices.size());
  std::mutex progressMutex;
  std::uint64_t done = 0;
  parallelForBlocks(vertices.size(), 8, [&](std::size_t begin, std::size_t end) {
    PilotTracer tracer(prepared, lattice, options);
    for (std::size_t i = begin; i < end; ++i) drawn[i] = tracer.trace(vertices[i]);
    const std::scoped_lock lock(progressMutex);
    done += end - begin;
    if (progress) progress({done, vertices.size(), 0});
  });

  BouncePilot pilot;
  const auto raysPerVertex = 2 * static_cast<double>(lattice.count());
  const double share = static_cast<double>(candidates.size()) / static_cast<double>(receivers);
  const UnshadowedTransfer unshadowed(options.bandDegree);
  std::vector<double> analytic(static_cast<std::size_t>(coefficientCount(options.bandDegree)));
  unshadowed.evaluate({0, 0, 1}, analytic);
  double unshadowedSquare = 0;
  for (int i = 0; i < coefficientCount(options.degree); ++i)
    unshadowedSquare += analytic[static_cast<std::size_t>(i)] * analytic[static_cast<std::size_t>(i)];

  pilot.vertices = drawn.size();
  pilot.paths = drawn.size() * static_cast<std::uint64_t>(2 * lattice.count());
  for (const PilotVertex& vertex : drawn) pilot.met += vertex.met;
  const Interval hidden = meanOf(drawn, share, [](const PilotVertex& v) { return 1 - v.visible; });
  pilot.hitShareOfCandidates = share > 0 ? hidden.value / share : 0;
  pilot.visibility = {1 - hidden.value, 1 - hidden.high, 1 - hidden.low};
  measureBounces(drawn, share, std::sqrt(unshadowedSquare), pilot);
  if (pilot.met == 0 && !drawn.empty()) {
    // Either few vertices see much of others, or, where all were drawn, few rays of few vertices do.
    const auto n = static_cast<double>(drawn.size());
    const double unseen = drawn.size() < candidates.size()
                              ? std::sqrt(share * std::min(1.0, kUnseenEvents / n))
                              : std::sqrt(share / n) * std::min(1.0, kUnseenEvents / raysPerVertex);
    pilot.total.high = pilot.colourBleed.high = examineMaterials(prepared.scene).brightest * unseen;
  }

  pilot.sureBounces = lastSure(drawn);
  const double before = powerBeyond(pilot, pilot.sureBounces);
  if (before > 0 && pilot.sureBounces > 0) {
    pilot.ratio = std::min(before / powerBeyond(pilot, pilot.sureBounces - 1), kLargestRatio);
  } else if (before > 0) {
    pilot.ratio = std::min(powerBeyond(pilot, 1) / before, kLargestRatio);
  }

  for (int l = 0; l <= options.bandDegree; ++l) {
    double bare = 0;
    for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i)
      bare += analytic[static_cast<std::size_t>(i)] * analytic[static_cast<std::size_t>(i)];
    const Interval energy = meanOf(
        drawn, share, [&](const PilotVertex& v) { return v.bandProducts[static_cast<std::size_t>(l)]; });
    pilot.bandEnergy.push_back(std::max(energy.value + (1 - share) * bare, 0.0));
  }
  for (const PilotVertex& vertex : drawn) {
    const double weight = share / static_cast<double>(drawn.size());
    pilot.emission[0] += weight * vertex.emission.x;
    pilot.emission[1] += weight * vertex.emission.y;
    pilot.emission[2] += weight * vertex.emission.z;
    pilot.emissionReach += vertex.emission == Vec3d{} ? 0 : weight;
  }

  const auto secondsPer = [&](double PilotSeconds::*part, double times) {
    double sum = 0;
    for (const PilotVertex& vertex : drawn) sum += vertex.seconds.*part;
    return drawn.empty() ? 0 : sum / (static_cast<double>(drawn.size()) * times);
  };
  pilot.secondsPerPoint = secondsPer(&PilotSeconds::point, 1);
  pilot.secondsPerShadowRay = secondsPer(&PilotSeconds::shadowRays, raysPerVertex);
  pilot.secondsPerNearestRay = secondsPer(&PilotSeconds::nearestRays, raysPerVertex);
  pilot.secondsPerTerm =
      secondsPer(&PilotSeconds::terms, raysPerVertex * coefficientCount(options.bandDegree));
  pilot.seconds = watch.seconds();
  return pilot;
}

}  // namespace shprt
