#include "shprt/study/study_reference.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "shprt/study/bake_response.h"
#include "shprt/study/study_bake.h"

namespace shprt {
namespace {

// Some seconds of rays, and about a minute; most of their hits still fit into a bake's memory.
constexpr double kQuickRays = 2e7, kFullRays = 5e8;
constexpr double kMostValues = 1 << 26;  // of the reference's transfer: 256 MiB
// Light is smooth when it has passed through these: what lies beyond hardly takes part in noise.
constexpr int kPilotDegree = 6;

int affordableRays(const StudyRun& run) {
  const double vertices = static_cast<double>(std::max<std::uint64_t>(1, run.plan.verticesBelow));
  const double rays = (run.options.quick ? kQuickRays : kFullRays) / vertices;
  const auto power = std::bit_floor(static_cast<std::uint64_t>(std::max(rays, 1.0)));
  return static_cast<int>(run.options.quick ? std::clamp<std::uint64_t>(power, 256, 16384)
                                            : std::clamp<std::uint64_t>(power, 1024, 65536));
}

int affordableDegree(const StudyRun& run) {
  if (!run.light) return run.options.degree;
  int degree = std::min(run.options.quick ? 12 : kMaximumBakeDegree, run.light->coefficients.degree);
  const double columns = 3.0 * static_cast<double>(run.prepared.scene.mesh.positions.size());
  while (degree > 0 && columns * coefficientCount(degree) > kMostValues) --degree;
  return degree;
}

}  // namespace

StudyReference::StudyReference(const StudyRun& run)
    : run_(run),
      traces_(run.plan.verticesBelow > 0 || run.prepared.scene.emits()),
      degree_(affordableDegree(run)),
      rays_(traces_ ? affordableRays(run) : 0),
      pilotDegree_(run.light ? std::min(kPilotDegree, degree_) : degree_) {}

const TransferAsset& StudyReference::asset() {
  if (asset_) return *asset_;
  BakeRequest request;
  request.model = traces_ ? "interreflected" : "unshadowed";
  request.degree = degree_;
  request.rays = rays_;
  request.seed = run_.options.seed + 7919;
  request.error = bounceError();
  asset_ = bakeForStudy(run_, request).asset;
  return *asset_;
}

double StudyReference::scale() {
  if (scale_) return *scale_;
  if (light()) {
    scale_ = normOf(responseOf(asset(), light(), degree_));
  } else {
    BakeRequest unshadowed;
    unshadowed.model = "unshadowed";
    unshadowed.degree = degree_;
    scale_ = normOf(responseOf(bakeForStudy(run_, unshadowed).asset, nullptr, degree_));
  }
  return *scale_;
}

double StudyReference::errorOf(const TransferAsset& judged) {
  return distanceOf(responseOf(judged, light(), judged.transfer.degree),
                    responseOf(asset(), light(), degree_)) /
         scale();
}

double StudyReference::errorWithin(int degree, const TransferAsset& judged) {
  return difference(degree, judged, asset());
}

double StudyReference::errorOfDegree(int degree) {
  return distanceOf(responseOf(asset(), light(), degree), responseOf(asset(), light(), degree_)) / scale();
}

double StudyReference::difference(int degree, const TransferAsset& a, const TransferAsset& b) {
  return distanceOf(responseOf(a, light(), degree), responseOf(b, light(), degree)) / scale();
}

}  // namespace shprt
