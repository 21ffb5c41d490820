#include "shprt/transfer/effect_plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "shprt/sh/basis.h"
#include "shprt/transfer/band_tails.h"
#include "shprt/transfer/effect_cost.h"
#include "shprt/transfer/material_evidence.h"
#include "shprt/transfer/stopwatch.h"
#include "shprt/transfer/vertices_below.h"

namespace shprt {
namespace {

// Bands that are looked at beyond the degree asked for.
constexpr int kFurtherBands = 8;
constexpr int kDefaultDegree = 4;
// The pilot's share of a bake's rays, and its bounds, in paths.
constexpr double kPilotShare = 0.003;
constexpr int kFewestPaths = 2048, kMostPaths = 65536;

std::string counted(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return digits;
}

std::string percent(double share) {
  return fmt::format("{:.3g}%", 100 * share);
}

PilotOptions pilotOptions(const PlanOptions& options, int bandDegree, std::size_t candidates) {
  const double bakeRays = static_cast<double>(candidates) * options.rays;
  const int paths = static_cast<int>(std::clamp<double>(kPilotShare * bakeRays, kFewestPaths, kMostPaths));
  const int perVertex = paths >= 32768 ? 128 : paths >= 8192 ? 64 : 32;
  return {options.degree.value_or(kDefaultDegree), bandDegree, paths / perVertex, perVertex, options.seed};
}

// Everything that findings are made from.
struct Evidence {
  const Scene& scene;
  const PlanOptions& options;
  MaterialEvidence materials;
  AssetContent content;
  BakeSeconds seconds;
};

EffectFinding findShadows(const EffectPlan& plan, const Evidence& evidence) {
  EffectFinding finding{.effect = "shadows"};
  if (plan.verticesBelow == 0) {
    finding.evidence = "no vertex has geometry above its tangent plane: the analytic transfer is exact";
    return finding;
  }
  finding.needed = true;
  finding.evidence =
      fmt::format("{} of {} vertices have geometry above their tangent plane; mean visibility {:.2f}",
                  counted(plan.verticesBelow), counted(plan.vertices), plan.pilot.visibility.value);
  finding.contribution = plan.pilot.shadow;
  finding.seconds = evidence.seconds.shadows;
  return finding;
}

EffectFinding findInterreflection(const EffectPlan& plan, const Evidence& evidence) {
  EffectFinding finding{.effect = "interreflection"};
  const BouncePilot& pilot = plan.pilot;
  finding.contribution = pilot.total;
  finding.needed = plan.bounces > 0;
  finding.seconds = finding.needed ? evidence.seconds.bounces : 0;
  const std::string drawn =
      fmt::format("{} paths from {} vertices", counted(pilot.paths), counted(pilot.vertices));
  if (plan.verticesBelow == 0)
    finding.evidence = "no vertex can see another surface";
  else if (evidence.materials.brightest <= 0)
    finding.evidence = "nothing reflects";
  else if (pilot.met == 0)
    finding.evidence = fmt::format("none of {} met a surface; what that leaves possible is {} the error",
                                   drawn, finding.needed ? "above" : "within");
  else if (!finding.needed)
    finding.evidence = fmt::format("{}: within the error", drawn);
  else if (pilot.total.high <= evidence.options.error)
    finding.evidence = fmt::format("{}: within the error, but light of the scene's own may bounce", drawn);
  else
    finding.evidence = fmt::format("{}: first bounce {}, ratio {:.2f}; {} until {} is left", drawn,
                                   percent(pilot.bounces[0].norm.value), pilot.ratio,
                                   plan.bounces == 1 ? "1 bounce" : fmt::format("{} bounces", plan.bounces),
                                   percent(evidence.options.error));
  return finding;
}

EffectFinding findEmission(const EffectPlan& plan, const Evidence& evidence) {
  EffectFinding finding{.effect = "emission"};
  if (!evidence.materials.emits) {
    finding.evidence = "no surface sends out light";
    return finding;
  }
  const double reached = *std::max_element(plan.pilot.emission.begin(), plan.pilot.emission.end());
  finding.contribution = {reached, reached, reached};
  finding.needed = evidence.materials.receiversEmit || plan.verticesBelow > 0;
  finding.bytes = finding.needed ? plan.vertices * sizeof(Vec3f) : 0;
  if (!finding.needed)
    finding.evidence = "no receiver can see the surfaces that send out light";
  else
    finding.evidence =
        fmt::format("{}light of the scene's own reached {} of the vertices drawn, mean irradiance/pi {:.3g}",
                    evidence.materials.receiversEmit ? "receivers send out light; " : "",
                    percent(plan.pilot.emissionReach), reached);
  return finding;
}

EffectFinding findDegree(const EffectPlan& plan, const Evidence& evidence, bool lights) {
  EffectFinding finding{.effect = "degree"};
  const auto tailAt = [&](int degree) {
    const DegreeTail& tail = plan.degreeTails[static_cast<std::size_t>(degree)];
    return lights ? tail.radiance : tail.transfer;
  };
  const int highest = static_cast<int>(plan.degreeTails.size()) - 1;
  int least = 0;
  while (least < highest && tailAt(least) > evidence.options.error) ++least;
  const double left = tailAt(std::min(plan.degree, highest));
  finding.needed = plan.degree > 0;
  finding.contribution = {left, left, left};
  finding.seconds = evidence.seconds.terms;
  finding.bytes = transferBytes(evidence.content) / static_cast<std::uint64_t>(evidence.content.channels);
  const std::string cut = plan.degree < highest
                              ? fmt::format("degree {} leaves out {}", plan.degree, percent(left))
                              : fmt::format("degree {} has all bands that were looked at", plan.degree);
  if (!lights)
    finding.evidence = fmt::format("no light given; {} of the transfer's bands to {}", cut, highest);
  else if (least >= highest)
    finding.evidence = fmt::format("{} of the radiance; no degree below {} meets the error", cut, highest);
  else
    finding.evidence = fmt::format("{} of the radiance; the least that meets the error is {}", cut, least);
  return finding;
}

EffectFinding findColour(const EffectPlan& plan, const Evidence& evidence) {
  EffectFinding finding{.effect = "colour"};
  finding.needed = plan.channels == 3;
  const MaterialEvidence& materials = evidence.materials;
  if (materials.grey) {
    finding.evidence = "every surface is grey: one channel says it all";
    return finding;
  }
  const Interval& bleed = plan.pilot.colourBleed;
  finding.contribution = {std::hypot(materials.colourSpread, bleed.value),
                          std::hypot(materials.colourSpread, bleed.low), materials.colourSpread + bleed.high};
  finding.bytes = finding.needed ? transferBytes(evidence.content) / 3 * 2 : 0;
  finding.evidence = fmt::format("albedo differs from grey by {}, bounced light by {}",
                                 percent(materials.colourSpread), percent(bleed.value));
  return finding;
}

EffectFinding findNearField() {
  return {.effect = "near field", .evidence = "no light is near"};
}

EffectFinding findMaterial(const char* effect, double area, double share) {
  EffectFinding finding{.effect = effect, .needed = area > 0};
  finding.contribution = {share, share, share};
  finding.evidence = area > 0 ? fmt::format("materials on {} of the area; {} of what the surfaces send on",
                                            percent(area), percent(share))
                              : "no material asks for it";
  return finding;
}

std::vector<DegreeTail> measureTails(const std::vector<double>& transferEnergy,
                                     std::span<const LightCoefficients> lights) {
  const int highest = static_cast<int>(transferEnergy.size()) - 1;
  const std::vector<double> transfer = tailShares(transferEnergy);
  const std::vector<double> radiance =
      tailShares(radianceBandEnergy(transferEnergy, lightBandEnergy(lights, highest)));
  std::vector<DegreeTail> tails;
  for (int n = 0; n <= highest; ++n)
    tails.push_back({n, transfer[static_cast<std::size_t>(n)], radiance[static_cast<std::size_t>(n)]});
  return tails;
}

int chooseDegree(const EffectPlan& plan, const PlanOptions& options, bool lights) {
  if (options.degree) return *options.degree;
  if (!lights) return kDefaultDegree;
  for (const DegreeTail& tail : plan.degreeTails) {
    if (tail.radiance <= options.error) return tail.degree;
  }
  return plan.degreeTails.back().degree;
}

AssetContent contentOf(const Scene& scene, const EffectPlan& plan, const PlanOptions& options) {
  AssetContent content{.vertices = plan.vertices,
                       .triangles = 0,
                       .degree = plan.degree,
                       .channels = plan.channels,
                       .half = options.half,
                       .textureCoordinates = !scene.mesh.textureCoordinates.empty(),
                       .emission = false};
  for (const Triangle& triangle : scene.mesh.triangles) content.triangles += scene.isReceiver(triangle[0]);
  return content;
}

}  // namespace

const EffectFinding& EffectPlan::finding(const std::string& effect) const {
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [&](const EffectFinding& finding) { return finding.effect == effect; });
  assert(found != findings.end());
  return *found;
}

EffectPlan planEffects(const PreparedScene& prepared, std::span<const LightCoefficients> lights,
                       const PlanOptions& options, const ProgressCallback& progress) {
  assert(options.rays >= 1 && options.error > 0);
  const Stopwatch watch;
  const Scene& scene = prepared.scene;
  EffectPlan plan;
  plan.rays = options.rays;
  plan.error = options.error;
  plan.buildSeconds = prepared.buildSeconds;
  Evidence evidence{scene, options, examineMaterials(scene), {}, {}};

  const VerticesBelow below = findVerticesBelow(prepared);
  plan.vertices = below.receivers;
  plan.verticesBelow = below.vertices.size();

  int bandDegree = options.degree.value_or(kDefaultDegree) + kFurtherBands;
  for (const LightCoefficients& light : lights) bandDegree = std::max(bandDegree, light.degree);
  bandDegree = std::min(bandDegree, kMaximumBakeDegree);
  plan.pilot = pilotBounces(prepared, below.vertices, plan.vertices,
                            pilotOptions(options, bandDegree, below.vertices.size()), progress);
  if (evidence.materials.grey) plan.pilot.colourBleed = {};

  plan.degreeTails = measureTails(plan.pilot.bandEnergy, lights);
  plan.degree = chooseDegree(plan, options, !lights.empty());
  const EffectFinding emission = findEmission(plan, evidence);
  plan.bounces = plan.pilot.total.high > options.error ? plan.pilot.bouncesFor(options.error) : 0;
  // In a closed room nothing comes from the sky, and its lamps bounce all the same.
  if (emission.needed && plan.verticesBelow > 0 && evidence.materials.brightest > 0)
    plan.bounces = std::max(plan.bounces, 1);
  const double colour = evidence.materials.colourSpread + plan.pilot.colourBleed.high;
  plan.channels = evidence.materials.grey || colour <= options.error ? 1 : 3;
  evidence.content = contentOf(scene, plan, options);
  evidence.content.emission = emission.needed;
  const bool interreflected = plan.bounces > 0 || emission.needed;
  evidence.seconds = predictSeconds(plan.pilot, {.points = prepared.topology.pointCount(),
                                                 .pointsBelow = below.points,
                                                 .rays = options.rays,
                                                 .degree = plan.degree,
                                                 .channels = plan.channels,
                                                 .interreflected = interreflected,
                                                 .bounces = plan.bounces,
                                                 .hitMemory = options.hitMemory});

  plan.findings = {findShadows(plan, evidence), findInterreflection(plan, evidence), emission,
                   findDegree(plan, evidence, !lights.empty()), findColour(plan, evidence)};
  for (EffectFinding& finding : plan.findings) finding.simulated = finding.needed;
  const MaterialEvidence& materials = evidence.materials;
  plan.findings.push_back(findNearField());
  plan.findings.push_back(findMaterial("glossy", materials.glossyArea, materials.glossyShare));
  plan.findings.push_back(
      findMaterial("translucency", materials.translucentArea, materials.translucentShare));
  plan.model = interreflected ? "interreflected" : plan.verticesBelow > 0 ? "shadowed" : "unshadowed";
  plan.seconds = (plan.model == "unshadowed" ? 0 : plan.buildSeconds) + evidence.seconds.shadows +
                 evidence.seconds.bounces;
  plan.bytes = assetBytes(evidence.content);
  plan.planSeconds = watch.seconds();
  return plan;
}

EffectPlan planEffects(const Scene& scene, std::span<const LightCoefficients> lights,
                       const PlanOptions& options, const ProgressCallback& progress) {
  return planEffects(PreparedScene(scene), lights, options, progress);
}

}  // namespace shprt
