#include "shprt/transfer/light_transport.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <mutex>

#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/buried_search.h"
#include "shprt/transfer/direct_transfer.h"
#include "shprt/transfer/hit_gatherer.h"
#include "shprt/transfer/light_norms.h"
#include "shprt/transfer/sent_light.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {
namespace {

constexpr std::size_t kBlock = 64;  // points that share a list of hits

float channelOf(Vec3f colour, int channel) {
  return channel == 0 ? colour.x : channel == 1 ? colour.y : colour.z;
}

std::vector<std::uint32_t> countReceivers(const Scene& scene, const SurfaceTopology& topology) {
  std::vector<std::uint32_t> counts(topology.pointCount());
  for (std::uint32_t vertex = 0; vertex < topology.pointIds().size(); ++vertex)
    counts[topology.pointIds()[vertex]] += scene.isReceiver(vertex);
  return counts;
}

}  // namespace

// What one block of points adds to the statistics.
struct LightTransport::BlockCounts {
  std::uint64_t rays = 0, spared = 0, hits = 0, sky = 0;
  std::uint64_t points = 0, unoccluded = 0, vertices = 0, open = 0, hidden = 0;
  std::size_t mostFronts = 0;

  void add(const BlockCounts& other) {
    rays += other.rays, spared += other.spared, hits += other.hits, sky += other.sky;
    points += other.points, unoccluded += other.unoccluded, vertices += other.vertices;
    open += other.open, hidden += other.hidden;
    mostFronts = std::max(mostFronts, other.mostFronts);
  }
};

LightTransport::LightTransport(const PreparedScene& prepared, const InterreflectedOptions& options,
                               BakeStatistics& statistics)
    : prepared_(prepared),
      scene_(prepared.scene),
      topology_(prepared.topology),
      options_(options),
      statistics_(statistics),
      bounces_(options.bounces != 0),
      layout_(lightLayout(scene_, options.degree)),
      lattice_(options.rays, kRayPacketSize),
      hits_((topology_.pointCount() + kBlock - 1) / kBlock, options.hitMemory),
      receivers_(countReceivers(scene_, topology_)),
      light_(topology_.pointCount(), layout_.columns()),
      sources_(bounces_ ? scene_.mesh.positions.size() : 0, layout_.columns()) {}

HitTracer LightTransport::makeTracer() const {
  return {scene_, prepared_.fronts(),
          HemisphereTracer(prepared_, lattice_, options_.seed, !options_.traceEverything)};
}

void LightTransport::trace(const ProgressCallback& progress) {
  const UnshadowedTransfer unshadowed(options_.degree);
  BuriedSearch buried;
  BlockCounts total;
  std::uint64_t done = 0;
  std::mutex totalMutex;
  parallelForBlocks(topology_.pointCount(), kBlock, [&](std::size_t begin, std::size_t end) {
    HitTracer tracer = makeTracer();
    DirectTransfer direct(options_.degree, unshadowed);
    BlockHits hits;
    BlockCounts counts;
    BuriedSearch buriedInBlock;
    for (std::size_t point = begin; point < end; ++point) {
      if (!isTraced(point)) {
        HitTracer::skip(hits);
        continue;
      }
      const std::size_t firstHit = hits.hits.size();
      const RayEnds ends = tracer.trace(point, hits);
      const std::span<const double> transfer = direct.evaluate(tracer.rays());
      float* row = light_.row(point);
      for (int channel = 0; channel < layout_.channels; ++channel)
        std::transform(transfer.begin(), transfer.end(), row + layout_.band(channel).first,
                       [](double value) { return static_cast<float>(value); });
      if (layout_.emission) {
        const Vec3f emission = meanEmission(scene_, std::span(hits.hits).subspan(firstHit),
                                            static_cast<std::size_t>(options_.rays));
        for (int channel = 0; channel < 3; ++channel)
          row[layout_.emissionColumn() + static_cast<std::size_t>(channel)] = channelOf(emission, channel);
      }

      const std::uint64_t receivers = receivers_[point];
      if (ends.mayBeBuried()) buriedInBlock.add(point, ends, std::span(hits.hits).subspan(firstHit));
      counts.rays += tracer.rays().rays();
      counts.hits += ends.fronts + ends.backs;
      counts.sky += ends.sky * receivers;
      counts.vertices += receivers;
      counts.points += receivers > 0;
      if (ends.sky == tracer.rays().rays()) counts.open += receivers;
      if (ends.sky == 0) counts.hidden += receivers;
      counts.mostFronts = std::max(counts.mostFronts, ends.fronts);
    }
    counts.spared = tracer.rays().raysSpared();
    counts.unoccluded = tracer.rays().unoccludedPoints();
    if (bounces_) hits_.keep(begin / kBlock, hits);
    const std::scoped_lock lock(totalMutex);
    total.add(counts);
    buried.add(std::move(buriedInBlock));
    done += end - begin;
    if (progress) progress({done, topology_.pointCount(), total.rays});
  });
  const std::vector<std::uint8_t> isBuried = buried.find(topology_);
  for (std::size_t point = 0; point < isBuried.size(); ++point)
    if (isBuried[point]) statistics_.buriedVertices += receivers_[point];
  buried_ = BuriedPoints(topology_, isBuried);
  buried_.fill(light_);

  const double rays = options_.rays;
  largestFrontShare_ = static_cast<double>(total.mostFronts) / rays;
  statistics_.rays = total.rays;
  statistics_.raysSpared = total.spared;
  statistics_.unoccludedPoints = total.unoccluded;
  statistics_.hits = total.hits;
  statistics_.hitBytes = hits_.bytes();
  statistics_.embreeBytes = prepared_.caster.peakMemory();
  statistics_.meanVisibility =
      total.vertices ? static_cast<double>(total.sky) / (rays * static_cast<double>(total.vertices)) : 1;
  statistics_.fullyVisible = total.open;
  statistics_.fullyHidden = total.hidden;
  statistics_.samplePoints = total.points;
}

// Returns the number of points whose rays had to be traced anew.
std::uint64_t LightTransport::gatherBlock(std::size_t begin, std::size_t end) {
  const BlockHits* hits = hits_.find(begin / kBlock);
  BlockHits traced;
  if (!hits) {
    HitTracer tracer = makeTracer();
    for (std::size_t point = begin; point < end; ++point) tracer.trace(point, traced);
  }
  const BlockHits& block = hits ? *hits : traced;
  HitGatherer gatherer(layout_, sources_, topology_.triangles(), static_cast<std::size_t>(options_.rays));
  std::size_t first = 0;
  for (std::size_t point = begin; point < end; ++point) {
    const std::size_t count = block.ends[point - begin] - first;
    gatherer.gather(std::span(block.hits).subspan(first, count),
                    block.albedo.empty() ? std::span<const CompactAlbedo>()
                                         : std::span(block.albedo).subspan(first, count),
                    light_.row(point));
    first += count;
  }
  return hits ? 0 : end - begin;
}

void LightTransport::bounce() {
  assert(bounces_);
  sendBack(scene_, topology_, layout_, light_, sources_);
  std::atomic<std::uint64_t> retraced = 0;
  parallelForBlocks(topology_.pointCount(), kBlock,
                    [&](std::size_t begin, std::size_t end) { retraced += gatherBlock(begin, end); });
  buried_.fill(light_);
  statistics_.retracedPoints = retraced;
  statistics_.rays += retraced * static_cast<std::uint64_t>(options_.rays);
}

std::vector<BandNorm> LightTransport::norms() const {
  std::vector<BandNorm> norms = bandNorms(light_, layout_, topology_, receivers_);
  const double unit = unshadowedNorm(options_.degree);
  for (int i = 0; i < layout_.channels; ++i) {
    BandNorm& norm = norms[static_cast<std::size_t>(i)];
    norm = {norm.receivers / unit, norm.all / unit};
  }
  return norms;
}

std::vector<double> LightTransport::largestRatios() const {
  std::vector<double> ratios;
  for (int i = 0; i < layout_.bandCount(); ++i) {
    const int channel = layout_.band(i).albedoChannel;
    float largest = 0;
    for (const Vec3f& albedo : scene_.albedo) largest = std::max(largest, channelOf(albedo, channel));
    for (const Image& texture : scene_.textures)
      for (const Vec3f& pixel : texture.pixels) largest = std::max(largest, channelOf(pixel, channel));
    ratios.push_back(static_cast<double>(largest) * largestFrontShare_);
  }
  return ratios;
}

}  // namespace shprt
