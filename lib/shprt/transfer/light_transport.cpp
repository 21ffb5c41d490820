#include "shprt/transfer/light_transport.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <mutex>
#include <numeric>

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

double channelOf(Vec3d colour, int channel) {
  return channel == 0 ? colour.x : channel == 1 ? colour.y : colour.z;
}

std::size_t countOf(std::span<const std::uint8_t> quarters, unsigned quarter) {
  return static_cast<std::size_t>(std::count(quarters.begin(), quarters.end(), quarter));
}

// The hits from `first` on by quarters.
std::array<std::span<const CompactHit>, 4> quartersOf(std::span<const CompactHit> hits, std::size_t first,
                                                      const std::array<std::uint32_t, 3>& ends) {
  return {hits.subspan(first, ends[0] - first), hits.subspan(ends[0], ends[1] - ends[0]),
          hits.subspan(ends[1], ends[2] - ends[1]), hits.subspan(ends[2])};
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
  std::uint64_t rays = 0, spared = 0, hits = 0;
  std::uint64_t points = 0, unoccluded = 0, vertices = 0, open = 0, hidden = 0;
  double mostFronts = 0;  // share of a point's rays

  void add(const BlockCounts& other) {
    rays += other.rays, spared += other.spared, hits += other.hits;
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
      samePlan_(options.rayPlan ? std::nullopt
                                : std::optional<RayPlan>(std::in_place, options.points, options.rays)),
      plan_(options.rayPlan ? *options.rayPlan : *samePlan_),
      burialPlan_(options.points, kBurialRays),
      hits_((topology_.pointCount() + kBlock - 1) / kBlock, options.hitMemory),
      receivers_(countReceivers(scene_, topology_)),
      light_(topology_.pointCount(), layout_.columns()),
      sources_(bounces_ ? scene_.mesh.positions.size() : 0, layout_.columns()),
      contrasts_(options.pointErrors ? 3 * topology_.pointCount() : 0,
                 static_cast<std::size_t>(layout_.coefficients) + (layout_.emission ? 3 : 0)) {}

HitTracer LightTransport::makeTracer(const RayPlan& plan, std::uint64_t seed) const {
  return {scene_, prepared_.fronts(),
          HemisphereTracer(prepared_, plan, seed, !options_.traceEverything && options_.controlVariate)};
}

void LightTransport::trace(const ProgressCallback& progress) {
  const UnshadowedTransfer unshadowed(options_.degree);
  if (options_.pointErrors) {
    *options_.pointErrors =
        PointErrors(topology_.pointCount(), {layout_.channels, options_.degree, layout_.emission});
  }
  std::vector<double> visibility((topology_.pointCount() + kBlock - 1) / kBlock);  // sums over vertices
  const bool known = options_.burials && !options_.burials->empty();
  BuriedSearch buried;
  BlockCounts total;
  std::uint64_t done = 0;
  std::mutex totalMutex;
  parallelForBlocks(topology_.pointCount(), kBlock, [&](std::size_t begin, std::size_t end) {
    HitTracer tracer = makeTracer(plan_, options_.seed), searcher = makeTracer(burialPlan_, kBurialSeed);
    DirectTransfer direct(options_.degree, unshadowed, options_.controlVariate);
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
        const Vec3f emission =
            meanEmission(scene_, std::span(hits.hits).subspan(firstHit), tracer.rays().rays());
        for (int channel = 0; channel < 3; ++channel)
          row[layout_.emissionColumn() + static_cast<std::size_t>(channel)] = channelOf(emission, channel);
      }

      if (options_.pointErrors)
        measureDirect(direct, tracer.rays(), point, quartersOf(hits.hits, firstHit, hits.quarterEnds.back()));
      const std::uint64_t receivers = receivers_[point];
      if (!known && ends.mightBeBuried()) {
        BlockHits found;
        const RayEnds foundEnds = searcher.trace(point, found);
        if (foundEnds.mayBeBuried()) buriedInBlock.add(point, foundEnds, found.hits);
      }
      counts.rays += tracer.rays().rays();
      counts.hits += ends.fronts + ends.backs;
      visibility[begin / kBlock] +=
          static_cast<double>(ends.sky * receivers) / static_cast<double>(ends.count());
      counts.vertices += receivers;
      counts.points += receivers > 0;
      if (ends.sky == tracer.rays().rays()) counts.open += receivers;
      if (ends.sky == 0) counts.hidden += receivers;
      counts.mostFronts =
          std::max(counts.mostFronts, static_cast<double>(ends.fronts) / static_cast<double>(ends.count()));
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
  std::vector<std::uint8_t> found;
  std::vector<std::uint8_t>& isBuried = options_.burials ? *options_.burials : found;
  if (isBuried.empty()) isBuried = buried.find(topology_);
  for (std::size_t point = 0; point < isBuried.size(); ++point)
    if (isBuried[point]) statistics_.buriedVertices += receivers_[point];
  buried_ = BuriedPoints(topology_, isBuried);
  buried_.fill(light_);

  largestFrontShare_ = total.mostFronts;
  statistics_.rays = total.rays;
  statistics_.raysSpared = total.spared;
  statistics_.unoccludedPoints = total.unoccluded;
  statistics_.hits = total.hits;
  statistics_.hitBytes = hits_.bytes();
  statistics_.embreeBytes = prepared_.caster.peakMemory();
  if (total.vertices > 0) {
    statistics_.meanVisibility =
        std::accumulate(visibility.begin(), visibility.end(), 0.0) / static_cast<double>(total.vertices);
  }
  statistics_.fullyVisible = total.open;
  statistics_.fullyHidden = total.hidden;
  statistics_.samplePoints = total.points;
}

// What of E_0 the quarters of a point's rays do not agree on. hits: by quarters.
void LightTransport::measureDirect(DirectTransfer& direct, const HemisphereTracer& rays, std::size_t point,
                                   const std::array<std::span<const CompactHit>, 4>& hits) {
  PointErrors& errors = *options_.pointErrors;
  errors.rays[point] = rays.isUnoccluded() ? 0 : static_cast<std::uint32_t>(rays.rays());
  const bool withRate = point % kRateStride == 0;
  const DirectTransfer::Parts parts = direct.parts(rays, withRate);
  if (withRate) storeRate(parts.contrasts, parts.sixteenthSquare, point, errors);
  std::array<Vec3d, 4> emission;
  if (layout_.emission)
    for (unsigned quarter = 0; quarter < 4; ++quarter)
      emission[quarter] = toDouble(
          meanEmission(scene_, hits[quarter], std::max<std::size_t>(countOf(rays.quarters(), quarter), 1)));
  for (std::size_t k = 0; k < 3; ++k) {
    float* row = contrasts_.row(3 * point + k);
    std::transform(parts.contrasts[k].begin(), parts.contrasts[k].end(), row,
                   [](double value) { return static_cast<float>(value); });
    if (!layout_.emission) continue;
    for (int channel = 0; channel < 3; ++channel) {
      const auto part = [&](std::size_t quarter) { return channelOf(emission[quarter], channel); };
      row[layout_.coefficients + channel] =
          static_cast<float>(contrastsOf(part(0), part(1), part(2), part(3))[k]);
    }
  }
}

// Calls visit(point, hits, albedo, ends of quarters) for the points of a block. Returns how many of them had
// to be traced anew.
template <class Visit>
std::uint64_t LightTransport::forHitsOf(std::size_t begin, std::size_t end, const Visit& visit) const {
  const BlockHits* hits = hits_.find(begin / kBlock);
  BlockHits traced;
  if (!hits) {
    HitTracer tracer = makeTracer(plan_, options_.seed);
    for (std::size_t point = begin; point < end; ++point) tracer.trace(point, traced);
  }
  const BlockHits& block = hits ? *hits : traced;
  std::size_t first = 0;
  for (std::size_t point = begin; point < end; ++point) {
    const std::size_t count = block.ends[point - begin] - first;
    visit(point, std::span(block.hits).subspan(first, count),
          block.albedo.empty() ? std::span<const CompactAlbedo>()
                               : std::span(block.albedo).subspan(first, count),
          std::array{block.quarterEnds[point - begin][0] - first, block.quarterEnds[point - begin][1] - first,
                     block.quarterEnds[point - begin][2] - first, count});
    first += count;
  }
  return hits ? 0 : end - begin;
}

void LightTransport::bounce() {
  assert(bounces_);
  sendBack(scene_, topology_, layout_, light_, sources_);
  std::atomic<std::uint64_t> retraced = 0, retracedRays = 0;
  parallelForBlocks(topology_.pointCount(), kBlock, [&](std::size_t begin, std::size_t end) {
    HitGatherer gatherer(layout_, sources_, topology_.triangles());
    const std::uint64_t points =
        forHitsOf(begin, end, [&](std::size_t point, auto hits, auto albedo, const auto&) {
          gatherer.gather(hits, albedo, static_cast<std::size_t>(plan_.rays(point)), light_.row(point));
        });
    retraced += points;
    if (points == 0) return;
    for (std::size_t point = begin; point < end; ++point)
      retracedRays += static_cast<std::uint64_t>(plan_.rays(point));
  });
  buried_.fill(light_);
  statistics_.retracedPoints = retraced;
  statistics_.rays += retracedRays;
}

void LightTransport::measureErrors(const LightRows& received) {
  if (bounces_) sendBack(scene_, topology_, layout_, received, sources_);
  PointErrors& errors = *options_.pointErrors;
  parallelForBlocks(topology_.pointCount(), kBlock, [&](std::size_t begin, std::size_t end) {
    HitGatherer gatherer(layout_, sources_, topology_.triangles());
    std::array<std::vector<float>, 4> gathered;
    gathered.fill(std::vector<float>(light_.stride()));
    std::vector<double> contrast(layout_.columns());
    const auto add = [&](std::size_t point) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < contrast.size(); ++i)
          contrast[i] =
              contrastsOf(static_cast<double>(gathered[0][i]), static_cast<double>(gathered[1][i]),
                          static_cast<double>(gathered[2][i]), static_cast<double>(gathered[3][i]))[k];
        const float* direct = contrasts_.row(3 * point + k);
        for (int i = 0; i < layout_.bandCount(); ++i) {
          const LightLayout::Band band = layout_.band(i);
          const float* part =
              i < layout_.channels ? direct : direct + layout_.coefficients + i - layout_.channels;
          for (std::size_t column = band.first; column < band.end; ++column)
            contrast[column] += static_cast<double>(part[column - band.first]);
        }
        addSquares(contrast, point, errors);
      }
    };
    if (!bounces_) {
      for (std::size_t point = begin; point < end; ++point) add(point);
      return;
    }
    forHitsOf(begin, end, [&](std::size_t point, auto hits, auto albedo, const auto& ends) {
      std::size_t first = 0;
      for (unsigned quarter = 0; quarter < 4; ++quarter) {
        const std::size_t count = ends[quarter] - first;
        const std::size_t rays = std::max<std::size_t>(countOf(plan_.set(point).quarters(), quarter), 1);
        gatherer.gather(hits.subspan(first, count), albedo.empty() ? albedo : albedo.subspan(first, count),
                        rays, gathered[quarter].data());
        first = ends[quarter];
      }
      add(point);
    });
  });
  buried_.fill(errors.squares);
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
