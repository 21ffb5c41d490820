// The effect plan: before a bake, cheap evidence decides which effects the scene calls for, so that the bake
// simulates only those. docs/effects.md says how each is decided and what is guaranteed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shprt/base/progress.h"
#include "shprt/coefficients/light_coefficients.h"
#include "shprt/scene/scene.h"
#include "shprt/transfer/bounce_pilot.h"
#include "shprt/transfer/prepared_scene.h"

namespace shprt {

struct PlanOptions {
  std::optional<int> degree = 4;  // asked for; nothing: the least that the lights call for
  int rays = 256;                 // per vertex, of the bake
  std::uint64_t seed = 1;
  double error = 0.01;  // that may be left out, in the units of BounceStatistics::norm
  std::uint64_t hitMemory = std::uint64_t{2} << 30;  // as InterreflectedOptions
  bool half = false;                                 // as WriteAssetOptions
};

struct EffectFinding {
  std::string effect;
  bool needed = false;
  bool simulated = false;   // whether the bake that is recommended has it
  std::string evidence{};   // one line
  Interval contribution{};  // what leaving it out would cost, in the measure; of emission: radiance
  double seconds = 0;       // that it takes of the bake
  std::uint64_t bytes = 0;  // that it takes of the asset
};

// What cutting off at a degree leaves out.
struct DegreeTail {
  int degree = 0;
  double transfer =
      0;  // RMS norm of the bands beyond, over that of the unshadowed transfer to the same degree
  double radiance = 0;  // RMS over vertices and all rotations of the light, relative; 0 without lights
};

struct EffectPlan {
  std::vector<EffectFinding> findings;  // shadows, interreflection, emission, degree, colour, near field,
                                        // glossy, translucency
  std::string model;                    // "unshadowed", "shadowed" or "interreflected"
  // Predicted; a bake that is left to find its own number (InterreflectedOptions::bounces unset, same error)
  // adds what remains as well. 0: none are called for, and a bake should be told so. Of light of the scene's
  // own the plan knows only that it bounces.
  int bounces = 0;
  int degree = 4;
  int channels = 1;
  int rays = 256;
  std::uint64_t vertices = 0;       // receivers
  std::uint64_t verticesBelow = 0;  // of them, with geometry above their tangent plane
  std::vector<DegreeTail> degreeTails;
  BouncePilot pilot;
  double error = 0.01;
  double buildSeconds = 0;  // acceleration structure; measured
  double seconds = 0;       // of the bake, building included where it traces; predicted
  std::uint64_t bytes = 0;  // of the asset; predicted
  double planSeconds = 0;   // what planning took, building apart

  const EffectFinding& finding(const std::string& effect) const;
};

// lights: as many as add up; distant ones. The same plan, seconds aside, for any number of threads. The scene
// has at least one receiver.
EffectPlan planEffects(const PreparedScene& prepared, std::span<const LightCoefficients> lights,
                       const PlanOptions& options, const ProgressCallback& progress = {});

// Prepares the scene first.
EffectPlan planEffects(const Scene& scene, std::span<const LightCoefficients> lights,
                       const PlanOptions& options, const ProgressCallback& progress = {});

}  // namespace shprt
