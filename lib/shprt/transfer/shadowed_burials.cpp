#include "shprt/transfer/shadowed_burials.h"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/buried_points.h"
#include "shprt/transfer/buried_search.h"
#include "shprt/transfer/direct_transfer.h"
#include "shprt/transfer/hit_tracer.h"
#include "shprt/transfer/light_rows.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {
namespace {

constexpr std::size_t kBlock = 64;
// In closed rooms most points see nothing, and few of them are buried: a glance of so many rays tells those
// that meet too few backs from those that are worth more. What decides are shares of rays, so no more than
// the second number are needed.
constexpr int kGlanceRays = 16, kMostRays = 64;

bool isWorthMore(const RayEnds& glance) {
  return 16 * glance.backs > glance.count();  // half of what makes a point likely enough to be buried
}

std::vector<std::uint8_t> findBuried(const PreparedScene& prepared, const ShadowedOptions& options,
                                     std::span<const std::uint32_t> hidden) {
  const FibonacciHemisphere glanceLattice(std::min(options.rays, kGlanceRays), kRayPacketSize),
      lattice(std::min(options.rays, kMostRays), kRayPacketSize);
  BuriedSearch search;
  std::mutex searchMutex;
  parallelForBlocks(hidden.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    const auto makeTracer = [&](const FibonacciHemisphere& directions) {
      return HitTracer(prepared.scene, prepared.fronts(),
                       HemisphereTracer(prepared, directions, options.seed, !options.traceEverything));
    };
    HitTracer glance = makeTracer(glanceLattice), tracer = makeTracer(lattice);
    BuriedSearch searchInBlock;
    for (const std::uint32_t point : hidden.subspan(begin, end - begin)) {
      BlockHits ignored, hits;
      if (!isWorthMore(glance.trace(point, ignored))) continue;
      const RayEnds ends = tracer.trace(point, hits);
      if (ends.mayBeBuried()) searchInBlock.add(point, ends, hits.hits);
    }
    const std::scoped_lock lock(searchMutex);
    search.add(std::move(searchInBlock));
  });
  return search.find(prepared.topology);
}

}  // namespace

void fillBuried(const PreparedScene& prepared, const FibonacciHemisphere& lattice,
                const ShadowedOptions& options, std::span<const std::uint32_t> hidden,
                const StoreBuried& store) {
  const std::vector<std::uint8_t> isBuried = findBuried(prepared, options, hidden);
  BuriedPoints buried(prepared.topology, isBuried);
  if (buried.none()) return;
  const std::vector<std::uint32_t> points = buried.renumber();

  // Neighbours are traced once more: that is cheaper than to keep the transfer of all points.
  LightRows rows(points.size(), static_cast<std::size_t>(coefficientCount(options.degree)));
  const UnshadowedTransfer unshadowed(options.degree);
  parallelForBlocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    HemisphereTracer tracer(prepared, lattice, options.seed, !options.traceEverything);
    DirectTransfer direct(options.degree, unshadowed);
    for (std::size_t i = begin; i < end; ++i) {
      if (isBuried[points[i]]) continue;
      tracer.traceVisibility(points[i]);
      const std::span<const double> transfer = direct.evaluate(tracer);
      std::transform(transfer.begin(), transfer.end(), rows.row(i),
                     [](double value) { return static_cast<float>(value); });
    }
  });
  buried.fill(rows);
  std::vector<double> transfer(static_cast<std::size_t>(coefficientCount(options.degree)));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!isBuried[points[i]]) continue;
    std::copy_n(rows.row(i), transfer.size(), transfer.begin());
    store(points[i], transfer);
  }
}

}  // namespace shprt
