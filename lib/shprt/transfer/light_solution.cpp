#include "shprt/transfer/light_solution.h"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

#include "shprt/base/parallel.h"
#include "shprt/transfer/bounce_series.h"
#include "shprt/transfer/light_transport.h"
#include "shprt/transfer/stopwatch.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {
namespace {

// Where nothing is lost, as in a closed room of albedo 1, light bounces for ever.
constexpr int kMaximumBounces = 1000;

// sum += light.
void addLight(const LightRows& light, LightRows& sum) {
  parallelForBlocks(sum.rows(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t point = begin; point < end; ++point)
      for (std::size_t column = 0; column < sum.stride(); ++column)
        sum.row(point)[column] += light.row(point)[column];
  });
}

// Adds what further bounces are likely to bring: factor * the last one, per band; but no more to any point
// and channel than leaves its mean over the sky, coefficient 0, below that of a point that sees all of it:
// surfaces that reflect at most what they receive send no more. Light fades faster at some points than on
// average.
void addTail(const LightTransport& transport, const std::vector<float>& factors, LightRows& sum) {
  const LightRows& light = transport.light();
  const LightLayout& layout = transport.layout();
  constexpr auto most = static_cast<float>(kUnshadowedMean);
  parallelForBlocks(sum.rows(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t point = begin; point < end; ++point)
      for (int i = 0; i < layout.bandCount(); ++i) {
        const LightLayout::Band band = layout.band(i);
        float factor = factors[static_cast<std::size_t>(i)];
        const float last = light.row(point)[band.first], soFar = sum.row(point)[band.first];
        if (i < layout.channels && factor * last > most - soFar)
          factor = last > 0 ? std::max(0.0f, most - soFar) / last : 0;
        for (std::size_t column = band.first; column < band.end; ++column)
          sum.row(point)[column] += factor * light.row(point)[column];
      }
  });
}

}  // namespace

LightSolution solveLight(const PreparedScene& prepared, const InterreflectedOptions& options,
                         const ProgressCallback& progress, BakeStatistics& statistics) {
  assert(prepared.scene.albedo.size() == prepared.scene.mesh.positions.size());
  assert(options.rays >= 1 && options.degree >= 0);
  assert(options.bounces ? *options.bounces >= 0 : options.error > 0);
  const Stopwatch traceWatch;
  LightTransport transport(prepared, options, statistics);
  transport.trace(progress);
  statistics.traceSeconds = traceWatch.seconds();

  const Stopwatch bounceWatch;
  const std::size_t points = transport.light().rows();
  LightRows sum(points, transport.layout().columns());
  addLight(transport.light(), sum);
  BounceSeries series(transport.layout().channels, transport.largestRatios());
  series.add(transport.norms());
  // Two bounces at least, because one ratio says little of how light fades in the end.
  const auto isEnough = [&] {
    const double remainder = series.remainder();
    return remainder == 0 || (series.bounces() >= 2 && remainder <= options.error);
  };
  const int most = options.bounces.value_or(kMaximumBounces);
  while (series.bounces() < most && (options.bounces || !isEnough())) {
    const Stopwatch watch;
    transport.bounce();
    addLight(transport.light(), sum);
    series.add(transport.norms());
    statistics.bounces.push_back({series.norm(), watch.seconds()});
    const auto bounces = static_cast<std::uint64_t>(series.bounces());
    const auto expected = static_cast<std::uint64_t>(options.bounces.value_or(series.bounces()));
    if (progress) progress({points + bounces, points + expected, statistics.rays});
  }
  statistics.spectralRadius = series.largestRatio();
  statistics.remainder = series.remainder();
  statistics.tailSummed = !options.bounces && isEnough() && statistics.remainder > 0;
  if (statistics.tailSummed) {
    std::vector<float> factors;
    for (int band = 0; band < transport.layout().bandCount(); ++band) {
      const double ratio = series.ratio(band);
      factors.push_back(static_cast<float>(ratio / (1 - ratio)));
    }
    addTail(transport, factors, sum);
  }
  if (options.pointErrors) transport.measureErrors(sum);
  statistics.bounceSeconds = bounceWatch.seconds();
  return {transport.layout(), std::move(sum), std::move(transport).takeLight()};
}

}  // namespace shprt
