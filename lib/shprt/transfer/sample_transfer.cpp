#include "shprt/transfer/sample_transfer.h"

#include <algorithm>
#include <cassert>
#include <mutex>
#include <optional>
#include <utility>

#include "shprt/base/parallel.h"
#include "shprt/sampling/fibonacci_hemisphere.h"
#include "shprt/sampling/random.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/direct_transfer.h"
#include "shprt/transfer/front_faces.h"
#include "shprt/transfer/hit_gatherer.h"
#include "shprt/transfer/hit_store.h"
#include "shprt/transfer/sample_tracer.h"
#include "shprt/transfer/sent_light.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {
namespace {

// Directions at sample i must not be those at vertex i.
constexpr std::uint64_t kSampleStream = 0x73616d706c6573;

// What surfaces send to samples: a row per render vertex (sent_light.h).
struct Surroundings {
  const LightLayout& layout;
  const LightRows& sent;
};

// The samples of one block go through here one after another; buffers are kept.
class SampleBaker {
 public:
  // surroundings: null where only the sky shines.
  SampleBaker(const PreparedScene& prepared, SampleTracer tracer, int degree,
              const UnshadowedTransfer& unshadowed, const Surroundings* surroundings)
      : scene_(prepared.scene), tracer_(std::move(tracer)), direct_(degree, unshadowed) {
    if (!surroundings) return;
    layout_ = surroundings->layout;
    gatherer_.emplace(layout_, surroundings->sent, prepared.topology.triangles());
    light_.resize(surroundings->sent.stride());
  }

  // Writes the sample's row.
  void bake(const SurfaceSample& sample, std::size_t index, std::span<float> row) {
    if (gatherer_) {
      tracer_.traceHits(sample, index);
      gather(row);
    } else {
      tracer_.traceVisibility(sample, index);
    }
    const std::span<const double> transfer = direct_.evaluate(tracer_);
    for (int channel = 0; channel < layout_.channels; ++channel)
      for (std::size_t i = 0; i < transfer.size(); ++i)
        row[static_cast<std::size_t>(channel) * transfer.size() + i] += static_cast<float>(transfer[i]);
    if (!gatherer_ && tracer_.visible() == 0) tracer_.traceHits(sample, index);
  }

  const SampleTracer& rays() const { return tracer_; }  // of the sample baked last

 private:
  void gather(std::span<float> row) {
    hits_.clear();
    albedo_.clear();
    for (std::size_t ray = 0; ray < tracer_.rays(); ++ray) {
      if (!tracer_.seesFront(ray)) continue;
      const SurfacePoint hit = tracer_.hit(ray);
      hits_.push_back(CompactHit::from(hit));
      if (!scene_.textures.empty())
        albedo_.push_back(CompactAlbedo::from(scene_.albedoAt(hit.triangle, hit.u, hit.v)));
    }
    gatherer_->gather(hits_, albedo_, tracer_.rays(), light_.data());
    std::copy_n(light_.begin(), row.size(), row.begin());
    if (!layout_.emission) return;
    const Vec3f emission = meanEmission(scene_, hits_, tracer_.rays());
    row[layout_.emissionColumn()] += emission.x;
    row[layout_.emissionColumn() + 1] += emission.y;
    row[layout_.emissionColumn() + 2] += emission.z;
  }

  const Scene& scene_;
  LightLayout layout_;
  SampleTracer tracer_;
  DirectTransfer direct_;
  std::optional<HitGatherer> gatherer_;
  std::vector<CompactHit> hits_;
  std::vector<CompactAlbedo> albedo_;
  std::vector<float> light_;
};

SampleTransfer bake(const PreparedScene& prepared, std::span<const SurfaceSample> samples,
                    const ShadowedOptions& options, const Surroundings* surroundings,
                    const ProgressCallback& progress) {
  assert(options.rays >= 1 && options.degree >= 0);
  SampleTransfer result;
  const std::size_t rows = surroundings ? surroundings->layout.columns()
                                        : static_cast<std::size_t>(coefficientCount(options.degree));
  result.transfer.rows = rows;
  result.transfer.values.resize(samples.size() * rows);
  std::vector<double> visibleAreas(samples.size());
  std::vector<std::uint8_t> buried(samples.size());  // not bool: threads write to neighbours
  const FrontFaces& fronts = prepared.fronts();
  const FibonacciHemisphere lattice(options.rays, kRayPacketSize);
  const UnshadowedTransfer unshadowed(options.degree);
  const std::uint64_t seed = hashCounter(options.seed, kSampleStream);
  std::uint64_t done = 0;
  std::mutex progressMutex;
  parallelForBlocks(samples.size(), 64, [&](std::size_t begin, std::size_t end) {
    SampleBaker baker(prepared, SampleTracer(prepared, fronts, lattice, seed), options.degree, unshadowed,
                      surroundings);
    for (std::size_t sample = begin; sample < end; ++sample) {
      baker.bake(samples[sample], sample, std::span(result.transfer.values).subspan(sample * rows, rows));
      visibleAreas[sample] = samples[sample].weight * static_cast<double>(baker.rays().visible());
      buried[sample] = baker.rays().isBuried();
    }
    const std::scoped_lock lock(progressMutex);
    done += end - begin;
    if (progress) progress({done, samples.size(), done * static_cast<std::uint64_t>(options.rays)});
  });

  result.rays = samples.size() * static_cast<std::uint64_t>(options.rays);
  double area = 0, visibleArea = 0;
  for (std::size_t sample = 0; sample < samples.size(); ++sample) {
    if (buried[sample]) result.buried.push_back(static_cast<std::uint32_t>(sample));
    area += samples[sample].weight;
    visibleArea += visibleAreas[sample];
  }
  if (area > 0) result.meanVisibility = visibleArea / (area * options.rays);
  return result;
}

}  // namespace

SampleTransfer bakeSamples(const PreparedScene& prepared, std::span<const SurfaceSample> samples,
                           const ShadowedOptions& options, const ProgressCallback& progress) {
  return bake(prepared, samples, options, nullptr, progress);
}

SampleTransfer gatherSamples(const PreparedScene& prepared, std::span<const SurfaceSample> samples,
                             const ShadowedOptions& options, const LightLayout& layout, const LightRows& sent,
                             const ProgressCallback& progress) {
  assert(layout.coefficients == coefficientCount(options.degree));
  assert(sent.rows() == prepared.scene.mesh.positions.size() && sent.stride() >= layout.columns());
  const Surroundings surroundings{layout, sent};
  return bake(prepared, samples, options, &surroundings, progress);
}

}  // namespace shprt
