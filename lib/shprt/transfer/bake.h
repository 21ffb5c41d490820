// The transport models: scene in, transfer coefficients out.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "shprt/base/progress.h"
#include "shprt/base/vec.h"
#include "shprt/coefficients/transfer_asset.h"
#include "shprt/sampling/hemisphere_set.h"
#include "shprt/scene/scene.h"
#include "shprt/transfer/point_errors.h"
#include "shprt/transfer/prepared_scene.h"
#include "shprt/transfer/ray_plan.h"

namespace shprt {

// What one bounce adds, over all receivers.
struct BounceStatistics {
  double norm = 0;  // RMS over receivers and channels of the 2-norm of what it adds, over that of the
                    // unshadowed transfer; per unit albedo
  double seconds = 0;
};

// One go at the rays: how many of all points together, and what they left uncertain.
struct SamplingPass {
  std::uint64_t rays = 0;
  double seconds = 0;
  double error = 0;  // as SamplingStatistics::error
};

// What sampling leaves uncertain, estimated from the differences between parts of each point's rays
// (sampling_error.h). Where rays were fixed and no error was asked for, all of it is empty.
struct SamplingStatistics {
  bool measured = false;
  double error = 0;  // RMS over receivers' vertices and channels of the 2-norm of the transfer's error, over
                     // that of the unshadowed transfer
  double errorBound = 0;     // which the true one exceeds with a probability of 5% (docs/accuracy.md)
  double rate = 0;           // error falls as rays^-rate; measured
  double emissionError = 0;  // RMS of that of light of the scene's own, over RMS of that light; 0 without
  double raysPerVertex = 0;  // mean over receivers' vertices of the rays that made the result
  // Receivers' vertices by their rays, where those differ rounded to a power of two (0: exact without);
  // increasing.
  std::vector<std::pair<int, std::uint64_t>> verticesByRays;
  std::vector<SamplingPass> passes;  // in order; all but the first are in the result
};

struct BakeStatistics {
  std::uint64_t rays = 0;         // rays decided, traced or spared
  double buildSeconds = 0;        // acceleration structure
  double traceSeconds = 0;        // rays and accumulation
  double bounceSeconds = 0;       // all bounces
  std::uint64_t embreeBytes = 0;  // most memory that Embree held at once
  double meanVisibility =
      1;  // mean over baked vertices of the visible share of the cosine-weighted hemisphere
  std::uint64_t fullyVisible = 0;  // receivers' vertices
  std::uint64_t fullyHidden = 0;
  std::uint64_t unoccludedPoints = 0;  // with nothing above their tangent plane: exact, without rays
  std::uint64_t raysSpared = 0;        // decided without being traced
  std::uint64_t samplePoints = 0;      // distinct (position, normal) that were baked
  std::uint64_t buriedVertices =
      0;                       // receivers' vertices inside other geometry; filled from their neighbours
  std::uint64_t hits = 0;      // rays that ended on a surface, front or back, blockers' rays included
  std::uint64_t hitBytes = 0;  // memory that held those on fronts
  // Whose rays were traced anew for every bounce, for lack of memory. Where it lacks, this and hitBytes
  // depend on the order in which threads came.
  std::uint64_t retracedPoints = 0;
  std::vector<BounceStatistics> bounces;  // in order
  double spectralRadius =
      0;  // the ratio of the last bounces' norms, largest over channels; 0 without bounces
  // Bound on what further bounces would add, in the units of BounceStatistics::norm; or, if larger, what they
  // would add of the scene's own lights, over all that those brought (see bounce_series.h).
  double remainder = 0;
  bool tailSummed = false;  // whether that was added as a geometric series
  SamplingStatistics sampling;
};

// One column per vertex of the scene. Blockers' columns are zero.
struct Bake {
  TransferCoefficients transfer;
  std::vector<Vec3f> emission;  // per vertex: outgoing radiance that the scene's own lights cause; or empty
  TransferError error;          // where it was asked for, else empty
  std::vector<Vec3f> emissionError;
  BakeStatistics statistics;
};

// Transfer without any shadow, from the normal alone: (albedo/pi) A_l y_lm(n). Exact to float. Emission is a
// vertex's own.
Bake bakeUnshadowed(const Scene& scene, int degree);

struct ShadowedOptions {
  int degree = 4;
  int rays = 256;  // per vertex
  std::uint64_t seed = 1;
  // Trace from points that nothing stands above, too: the same transfer, later.
  bool traceEverything = false;
  PointSet points = PointSet::kLattice;
  const RayPlan* rayPlan = nullptr;    // what each point takes, instead of `rays` of `points`
  PointErrors* pointErrors = nullptr;  // filled, where it is given
  // Per point, whether it is buried: taken from there where it is not empty, else filled. A fact of the scene,
  // which bakes of it with other rays need not find out again.
  std::vector<std::uint8_t>* burials = nullptr;
  // Estimate by rays only the difference from the unshadowed transfer (direct_transfer.h). Without it, as
  // others do; for comparison.
  bool controlVariate = true;
};

// Transfer with shadows that all objects cast, by cosine-distributed rays (see shadowed.cpp). Vertices that
// lie inside other geometry get what their neighbours have, as in bakeInterreflected. The scene must not
// emit: what its lights reach only bakeInterreflected knows.
Bake bakeShadowed(const PreparedScene& prepared, const ShadowedOptions& options,
                  const ProgressCallback& progress = {});
Bake bakeShadowed(const Scene& scene, const ShadowedOptions& options, const ProgressCallback& progress = {});
// The same surfaces with other albedo: an entry per vertex.
Bake bakeShadowed(const PreparedScene& prepared, std::span<const Vec3f> albedo,
                  const ShadowedOptions& options, const ProgressCallback& progress = {});

struct InterreflectedOptions {
  int degree = 4;
  int rays = 256;  // per vertex
  std::uint64_t seed = 1;
  // How often light may bounce between surfaces before it reaches a vertex; 0 is shadowed transfer with
  // emitters seen directly. Without a number: until what remains is at most `error`, and then the rest as a
  // geometric series; after 1000 bounces it stops in any case.
  std::optional<int> bounces = {};
  double error = 0.01;  // of `remainder` in BakeStatistics; above 0
  std::uint64_t hitMemory = std::uint64_t{2}
                            << 30;  // bytes of hits to keep; rays beyond are traced anew for every bounce
  bool traceEverything = false;     // as ShadowedOptions
  PointSet points = PointSet::kLattice;
  const RayPlan* rayPlan = nullptr;
  PointErrors* pointErrors = nullptr;
  std::vector<std::uint8_t>* burials = nullptr;
  bool controlVariate = true;
};

// Transfer with shadows and light that bounces between diffuse surfaces, and what the scene's own lights send
// to each vertex (see interreflected.cpp). Fronts reflect and emit, backs are black. Vertices that lie inside
// other geometry, and see only backs, get what their neighbours on the same smooth surface have
// (buried_points.h). Same bits whatever the threads and hitMemory.
Bake bakeInterreflected(const PreparedScene& prepared, const InterreflectedOptions& options,
                        const ProgressCallback& progress = {});
Bake bakeInterreflected(const Scene& scene, const InterreflectedOptions& options,
                        const ProgressCallback& progress = {});

}  // namespace shprt
