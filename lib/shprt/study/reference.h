// What the experiments of a study measure against: receivers' vertices drawn at random, bakes of those alone
// with as many rays as truth needs, and the two measures of error, of transfer and of radiance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/coefficients/transfer_asset.h"
#include "shprt/scene/scene.h"
#include "shprt/study/study_run.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/prepared_scene.h"

namespace shprt {

// Made on the first call of get(): a study that goes on after a break may never ask.
template <class Value>
class Lazy {
 public:
  explicit Lazy(std::function<Value()> make) : make_(std::move(make)) {}
  const Value& get() {
    if (!value_) value_.emplace(make_());
    return *value_;
  }

 private:
  std::function<Value()> make_;
  std::optional<Value> value_;
};

// The columns of some vertices, in their order.
TransferCoefficients selectColumns(const TransferCoefficients& transfer,
                                   std::span<const std::uint32_t> vertices);

// Some receivers' vertices. Bakes of them trace the rays that bakes of the whole scene trace from them, and
// no others. Only for vertices inside other geometry the results differ: a bake finds those by what their
// neighbours see.
class VertexSample {
 public:
  // The scene must outlive it. vertices: increasing, of receivers.
  VertexSample(const Scene& scene, std::vector<std::uint32_t> vertices);

  std::span<const std::uint32_t> vertices() const { return vertices_; }  // increasing
  // Shadowed transfer, one column per vertex of the sample. The scene's own lights are left out.
  TransferCoefficients bake(const ShadowedOptions& options) const;

 private:
  const PreparedScene& prepared() const;

  const Scene& scene_;
  std::vector<std::uint32_t> vertices_;
  // Everything else as blockers; made for the first bake.
  mutable std::unique_ptr<Scene> alone_;
  mutable std::unique_ptr<PreparedScene> prepared_;
};

// The scene without what no shadow depends on: its own lights and textures.
Scene shadowScene(const Scene& scene);

std::vector<std::uint32_t> receiverVertices(const Scene& scene);
// Vertices that stand for all receivers', in increasing order: one at random from each of `atMost` runs of
// equally many; all, where there are no more than that.
std::vector<std::uint32_t> drawVertices(const Scene& scene, std::size_t atMost, std::uint64_t seed);

// RMS over vertices and channels of the 2-norm of a vertex's coefficients.
double rmsNorm(const TransferCoefficients& transfer);
// The same of the difference of two transfers of one shape.
double rmsDifference(const TransferCoefficients& a, const TransferCoefficients& b);
// The same of the unshadowed transfer of these vertices: what errors of transfer are relative to.
double unshadowedRms(const Scene& scene, std::span<const std::uint32_t> vertices, int degree);
// RMS over vertices and channels of the difference, over the RMS of the reference. 0 where both are black.
double radianceError(std::span<const Vec3f> radiance, std::span<const Vec3f> reference);

// a / b, and 0 where b is.
double shareOf(double a, double b);

// As many vertices as the effort allows (curve_effort.h), the same for all experiments of a study: without
// those inside other geometry, so that bakes of the sample are bakes of the whole.
VertexSample sampleOf(const StudyRun& run);
// References are of another seed than what is measured.
std::uint64_t referenceSeed(const StudyOptions& options);

}  // namespace shprt
