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
// that meet too few backs from those that are worth more.
constexpr int kGlanceRays = 16;

std::vector<std::uint8_t> findBuried(const PreparedScene& prepared, const ShadowedOptions& options,
                                     std::span<const std::uint32_t> hidden) {
  const RayPlan glancePlan(options.points, kGlanceRays), plan(options.points, kBurialRays);
  BuriedSearch search;
  std::mutex searchMutex;
  parallelForBlocks(hidden.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    const auto makeTracer = [&](const RayPlan& rays) {
      return HitTracer(prepared.scene, prepared.fronts(),
                       HemisphereTracer(prepared, rays, kBurialSeed, !options.traceEverything));
    };
    HitTracer glance = makeTracer(glancePlan), tracer = makeTracer(plan);
    BuriedSearch searchInBlock;
    for (const std::uint32_t point : hidden.subspan(begin, end - begin)) {
      BlockHits ignored, hits;
      if (!glance.trace(point, ignored).mightBeBuried()) continue;
      const RayEnds ends = tracer.trace(point, hits);
      if (ends.mayBeBuried()) searchInBlock.add(point, ends, hits.hits);
    }
    const std::scoped_lock lock(searchMutex);
    search.add(std::move(searchInBlock));
  });
  return search.find(prepared.topology);
}

}  // namespace

void fillBuried(const PreparedScene& prepared, const RayPlan& plan, const ShadowedOptions& options,
                std::span<const std::uint32_t> hidden, const StoreBuried& store) {
  std::vector<std::uint8_t> found;
  std::vector<std::uint8_t>& isBuried = options.burials ? *options.burials : found;
  if (isBuried.empty()) isBuried = findBuried(prepared, options, hidden);
  BuriedPoints buried(prepared.topology, isBuried);
  if (buried.none()) return;
  if (options.pointErrors) buried.fill(options.pointErrors->squares);
  const std::vector<std::uint32_t> points = buried.renumber();

  // Neighbours are traced once more: that is cheaper than to keep the transfer of all points.
  LightRows rows(points.size(), static_cast<std::size_t>(coefficientCount(options.degree)));
  const UnshadowedTransfer unshadowed(options.degree);
  parallelForBlocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    HemisphereTracer tracer(prepared, plan, options.seed, !options.traceEverything && options.controlVariate);
    DirectTransfer direct(options.degree, unshadowed, options.controlVariate);
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
