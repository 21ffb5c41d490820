#include "shprt/transfer/controlled_bake.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "shprt/sampling/random.h"
#include "shprt/transfer/merge_pass.h"
#include "shprt/transfer/ray_allocation.h"
#include "shprt/transfer/sampling_error.h"
#include "shprt/transfer/stopwatch.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {
namespace {

// Between what is predicted and what is asked for: predictions miss by a few percent, and a further pass
// costs more than they.
constexpr double kErrorMargin = 0.94, kTimeMargin = 0.85;
// Lattices gain less with every doubling of their rays, down to n^(-3/2) of the variance, which is
// what straight edges of shadows leave. A prediction that is too good costs a further pass.
constexpr double kFirstExponent = 1.6, kLaterExponent = 1.5;
// What the first pass tells of its error over what is: a sixteenth of its rays are two, too few to show how
// fast errors fall.
constexpr double kFirstExcess = 1.3;
constexpr double kMostGrowth = 16;      // from the first pass to the next, if predictions are to hold
constexpr double kSafeGrowth = 4;       // the same for predictions of time
constexpr double kFixedShare = 0.3;     // of the first pass's time, what is not for rays; a guess
constexpr double kLeastRayShare = 0.6;  // of a later pass's time, what is for rays
constexpr double kMostOfNext = 2;       // the error of a pass that comes again, over that of those before
constexpr double kWorthwhile = 0.5;     // rays that there is time for, over those so far
constexpr int kMostPasses = 8;

class ControlledBake {
 public:
  ControlledBake(const PreparedScene& prepared, const SamplingControl& control,
                 const SamplingPassFunction& pass, const ProgressCallback& progress)
      : prepared_(prepared),
        control_(control),
        pass_(pass),
        progress_(progress),
        weights_(pointWeights(prepared.scene, prepared.topology)),
        unshadowedSquare_(unshadowedNorm(control.degree) * unshadowedNorm(control.degree)) {}

  Bake run() {
    if (control_.rays) {
      runPass(RayPlan(control_.points, *control_.rays), control_.seed, 1);
      return finish();
    }
    runPass(RayPlan(control_.points, RayPlan::kLeastRays), passSeed(), kPilotShare);
    while (passes_.size() < kMostPasses) {
      RayAllocation next = chooseNext();
      if (next.levels.empty()) break;
      runPass(RayPlan(control_.points, std::move(next.levels)), passSeed(), kPassShare);
    }
    return finish();
  }

 private:
  static constexpr double kPilotShare = 0.1, kPassShare = 0.9;  // of what is left of the progress bar

  std::uint64_t passSeed() const { return hashCounter(control_.seed, passes_.size()); }

  void runPass(const RayPlan& plan, std::uint64_t seed, double progressShare) {
    const Stopwatch watch;
    if (!isWorthKeeping()) {  // its memory is the next one's
      bake_ = {};
      errors_ = {};
    }
    PointErrors errors;
    Bake bake = pass_({plan, seed, errors, burials_}, listen(progressShare));
    SamplingPass pass{bake.statistics.rays, 0, 0};
    raysOfPassBefore_ = passRays_;
    passRays_ = raysOf(errors);
    raysBefore_ += bake.statistics.rays;
    sparedBefore_ += bake.statistics.raysSpared;
    traceSecondsBefore_ += bake.statistics.traceSeconds;
    const double exponent = toVariances(weights_, errors);
    SamplingStatistics sampling;
    measureSamplingError(errors, weights_, unshadowedSquare_, sampling);
    pass.error = sampling.error;
    if (!bake_.transfer.values.empty())
      mergePass(bake_, errors_, sampling_.error, bake, errors, sampling.error);
    bake_ = std::move(bake);
    errors_ = std::move(errors);
    sampling_ = {};
    measureSamplingError(errors_, weights_, unshadowedSquare_, sampling_);
    sampling_.rate = exponent / 2;
    pass.seconds = watch.seconds();
    passes_.push_back(pass);
    shown_ += (1 - shown_) * progressShare;
  }

  // The first pass is too rough to add anything.
  bool isWorthKeeping() const { return passes_.size() > 1; }

  // The rays of the next pass; no levels where there is to be none.
  RayAllocation chooseNext() const {
    const double asked = control_.error.value_or(0);
    if (sampling_.error == 0 || sampling_.errorBound <= asked) return {};
    const RayAllocator allocator(errors_, prepared_.topology, weights_, unshadowedSquare_,
                                 passes_.size() == 1 ? kFirstExponent : kLaterExponent);
    const double affordable = affordableRays();
    RayAllocation next =
        control_.error ? allocator.forError(errorOfNext(asked)) : allocator.forRays(affordable);
    if (next.rays > affordable) next = allocator.forRays(affordable);
    if (affordable < kWorthwhile * raysOf(errors_)) return {};
    if (passes_.size() == 1 && next.rays > kMostGrowth * passRays_)
      next = allocator.forRays(next.rays / (0.5 * kMostGrowth));
    // What a ray costs is a guess so far.
    if (passes_.size() == 1 && control_.seconds && next.rays > kSafeGrowth * passRays_)
      next = allocator.forRays(std::max(passRays_, std::min(next.rays, affordable / 3)));
    return next;
  }

  // What the next pass must reach by itself, so that with what there is already the bound is as asked.
  double errorOfNext(double asked) const {
    const double wanted = asked * kErrorMargin * sampling_.error / sampling_.errorBound;
    if (passes_.size() == 1) return wanted * kFirstExcess;
    const double missing = 1 / (wanted * wanted) - 1 / (sampling_.error * sampling_.error);
    return std::min(1 / std::sqrt(std::max(missing, 1e-300)), kMostOfNext * sampling_.error);
  }

  static double raysOf(const PointErrors& errors) {
    return std::accumulate(errors.rays.begin(), errors.rays.end(), 0.0);
  }

  // Seconds of a pass are linear in its rays: a part is for every point, whatever it takes. Two passes tell
  // how large it is.
  double affordableRays() const {
    if (!control_.seconds) return std::numeric_limits<double>::infinity();
    const double left = std::max(*control_.seconds - watch_.seconds(), 0.0) * kTimeMargin;
    const double seconds = passes_.back().seconds, mean = seconds / passRays_;
    double perRay = (1 - kFixedShare) * mean;
    if (passes_.size() > 1)
      perRay = (seconds - passes_[passes_.size() - 2].seconds) / (passRays_ - raysOfPassBefore_);
    perRay = std::isfinite(perRay) ? std::clamp(perRay, kLeastRayShare * mean, mean) : mean;
    return std::max(0.0, (left - (seconds - perRay * passRays_)) / perRay);
  }

  ProgressCallback listen(double share) const {
    if (!progress_) return {};
    return [this, share](const ProgressReport& part) {
      constexpr double kUnits = 10000;
      const double done =
          static_cast<double>(part.done) / static_cast<double>(std::max<std::uint64_t>(part.total, 1));
      progress_({static_cast<std::uint64_t>(kUnits * (shown_ + (1 - shown_) * share * std::min(done, 1.0))),
                 static_cast<std::uint64_t>(kUnits), raysBefore_ + part.rays});
    };
  }

  Bake finish() {
    BakeStatistics& statistics = bake_.statistics;
    statistics.rays = raysBefore_;
    statistics.raysSpared = sparedBefore_;
    statistics.traceSeconds = traceSecondsBefore_;
    statistics.sampling = sampling_;
    statistics.sampling.passes = passes_;
    countRays(errors_, prepared_.scene, prepared_.topology, statistics.sampling);
    const double exponent = 2 * sampling_.rate;
    storeErrors(errors_, smoothVariances(errors_, prepared_.topology, exponent), exponent, prepared_.scene,
                prepared_.topology, bake_);
    return std::move(bake_);
  }

  const Stopwatch watch_;
  const PreparedScene& prepared_;
  const SamplingControl& control_;
  const SamplingPassFunction& pass_;
  const ProgressCallback& progress_;
  const std::vector<Vec3d> weights_;
  const double unshadowedSquare_;
  Bake bake_;
  PointErrors errors_;
  std::vector<std::uint8_t> burials_;
  SamplingStatistics sampling_;
  // Of the last pass, and the one before it, of points that are not exact.
  double passRays_ = 0, raysOfPassBefore_ = 0;
  std::vector<SamplingPass> passes_;
  std::uint64_t raysBefore_ = 0, sparedBefore_ = 0;
  double traceSecondsBefore_ = 0;
  double shown_ = 0;  // of the progress
};

}  // namespace

Bake bakeControlled(const PreparedScene& prepared, const SamplingControl& control,
                    const SamplingPassFunction& pass, const ProgressCallback& progress) {
  assert(control.rays.value_or(1) >= 1 && control.error.value_or(1) > 0 && control.seconds.value_or(1) > 0);
  assert(control.rays || control.error || control.seconds);
  return ControlledBake(prepared, control, pass, progress).run();
}

}  // namespace shprt
