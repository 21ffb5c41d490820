#include "shprt/transfer/fitted.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/light_solution.h"
#include "shprt/transfer/sample_transfer.h"
#include "shprt/transfer/sent_light.h"
#include "shprt/transfer/stopwatch.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {
namespace {

// The samples of a bake, and its progress: one count from 0 to the end over vertices and samples.
class SampledBake {
 public:
  SampledBake(const PreparedScene& prepared, const SampleOptions& options, const ProgressCallback& progress)
      : samples(sampleSurface(prepared.scene, prepared.topology, options)),
        points_(prepared.topology.pointCount()),
        progress_(progress) {}

  ProgressCallback vertexProgress() const {
    if (!progress_) return {};
    return [this](const ProgressReport& part) {
      // Bounces would count on beyond the points; they take little beside the samples.
      progress_({std::min(part.done, points_), points_ + samples.size(), part.rays});
    };
  }
  ProgressCallback sampleProgress(std::uint64_t rays) const {
    if (!progress_) return {};
    return [this, rays](const ProgressReport& part) {
      progress_({points_ + part.done, points_ + samples.size(), rays + part.rays});
    };
  }

  std::vector<SurfaceSample> samples;

 private:
  std::uint64_t points_;
  const ProgressCallback& progress_;
};

// Keeps what a vertex receives of a sky that shines evenly, which the first coefficient tells, between none
// and `most`. Least squares overshoots where a shadow's edge crosses a triangle, and most at vertices that
// are themselves out of sight; light that is negative or more than there is would show. Beyond the most, the
// fit is scaled down; below none, it is left on the way from the start, which is a transfer that some
// visibility has.
void keepPossible(std::span<const double> start, double most, std::span<double> fit) {
  const double share = fit[0];
  if (share > most)
    for (double& coefficient : fit) coefficient *= most / share;
  if (share >= 0) return;
  const double step = std::max(start[0], 0.0) / (std::max(start[0], 0.0) - share);
  for (std::size_t i = 0; i < fit.size(); ++i) fit[i] = start[i] + step * (fit[i] - start[i]);
}

// keepPossible for every vertex and band. Both hold [column][vertex].
void keepPossible(const LightLayout& layout, std::span<const float> start, std::span<float> fit) {
  const std::size_t vertexCount = fit.size() / layout.columns();
  parallelForBlocks(vertexCount, 1024, [&](std::size_t begin, std::size_t end) {
    std::vector<double> from, to;
    for (std::size_t vertex = begin; vertex < end; ++vertex)
      for (int i = 0; i < layout.bandCount(); ++i) {
        const LightLayout::Band band = layout.band(i);
        from.clear(), to.clear();
        for (std::size_t column = band.first; column < band.end; ++column) {
          from.push_back(static_cast<double>(start[column * vertexCount + vertex]));
          to.push_back(static_cast<double>(fit[column * vertexCount + vertex]));
        }
        keepPossible(from, i < layout.channels ? kUnshadowedMean : std::numeric_limits<double>::infinity(),
                     to);
        for (std::size_t column = band.first; column < band.end; ++column)
          fit[column * vertexCount + vertex] = static_cast<float>(to[column - band.first]);
      }
  });
}

// Multiplies what is received of the scene's own lights.
void scaleEmission(const LightLayout& layout, float factor, SampleValues& measured, std::span<float> start) {
  for (std::size_t first = 0; first < measured.values.size(); first += measured.rows)
    for (std::size_t column = layout.emissionColumn(); column < measured.rows; ++column)
      measured.values[first + column] *= factor;
  const std::size_t vertexCount = start.size() / layout.columns();
  for (std::size_t i = layout.emissionColumn() * vertexCount; i < start.size(); ++i) start[i] *= factor;
}

// The most that a sample receives of the scene's own lights, in any colour; 1 where it is nothing.
float mostEmission(const LightLayout& layout, const SampleValues& measured) {
  float most = 0;
  for (std::size_t first = 0; first < measured.values.size(); first += measured.rows)
    for (std::size_t column = layout.emissionColumn(); column < measured.rows; ++column)
      most = std::max(most, measured.values[first + column]);
  return most > 0 ? most : 1;
}

// Albedo times what vertices receive. received: [column][vertex].
void storeReceived(const Scene& scene, const LightLayout& layout, std::span<const float> received,
                   Bake& bake) {
  const std::size_t vertexCount = scene.mesh.positions.size();
  if (layout.emission) bake.emission = ownEmission(scene);
  parallelForBlocks(vertexCount, 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t vertex = begin; vertex < end; ++vertex) {
      if (!scene.isReceiver(static_cast<std::uint32_t>(vertex))) continue;
      const Vec3f albedo = scene.albedo[vertex];
      const float channelAlbedo[3] = {albedo.x, albedo.y, albedo.z};
      // Without bounces one channel is received, and serves all.
      for (int channel = 0; channel < bake.transfer.channels; ++channel) {
        const LightLayout::Band band = layout.band(std::min(channel, layout.channels - 1));
        for (int i = 0; i < layout.coefficients; ++i)
          bake.transfer.row(channel, i)[vertex] =
              channelAlbedo[channel] *
              received[(band.first + static_cast<std::size_t>(i)) * vertexCount + vertex];
      }
      if (!layout.emission) continue;
      const float* emission = received.data() + layout.emissionColumn() * vertexCount + vertex;
      bake.emission[vertex] += Vec3f{albedo.x * emission[0], albedo.y * emission[vertexCount],
                                     albedo.z * emission[2 * vertexCount]};
    }
  });
}

// From what was measured at the samples and a start at the vertices ([column][vertex]), both per unit albedo,
// to coefficients. fitted.bake holds the vertices' statistics, and zeroed transfer.
void fitReceived(const PreparedScene& prepared, const LightLayout& layout,
                 std::vector<SurfaceSample>& samples, SampleTransfer& measured, std::vector<float> start,
                 const FitOptions& options, FittedBake& fitted) {
  const Stopwatch watch;
  fitted.samples = samples.size();
  fitted.buriedSamples = measured.buried.size();
  fitted.bake.statistics.rays += measured.rays;
  fitted.bake.statistics.samplePoints += fitted.samples;
  fitted.bake.statistics.traceSeconds += fitted.sampleSeconds;
  removeSamples(measured.buried, samples, measured.transfer);
  // All rows are solved to the accuracy of the largest, which bright lights must not be.
  const float unit = mostEmission(layout, measured.transfer);
  scaleEmission(layout, 1 / unit, measured.transfer, start);
  fitted.fit = fitToSamples(prepared.topology, samples, measured.transfer, start, options);
  std::vector<float> values = std::exchange(fitted.fit.values, {});
  keepPossible(layout, start, values);
  for (std::size_t i = layout.emissionColumn() * prepared.scene.albedo.size(); i < values.size(); ++i)
    values[i] *= unit;
  storeReceived(prepared.scene, layout, values, fitted.bake);
  fitted.fitSeconds = watch.seconds();
}

// [point][column] to [column][vertex].
std::vector<float> atVertices(const SurfaceTopology& topology, const LightLayout& layout,
                              const LightRows& received) {
  const std::size_t vertexCount = topology.positions().size();
  std::vector<float> values(layout.columns() * vertexCount);
  for (std::size_t vertex = 0; vertex < vertexCount; ++vertex) {
    const float* row = received.row(topology.pointIds()[vertex]);
    for (std::size_t column = 0; column < layout.columns(); ++column)
      values[column * vertexCount + vertex] = row[column];
  }
  return values;
}

// What vertices send to samples, so that nothing arrives there that has bounced more often than asked for.
LightRows sentToSamples(const PreparedScene& prepared, LightSolution& light, bool isCounted) {
  if (isCounted)
    for (std::size_t point = 0; point < light.received.rows(); ++point) {
      const float* all = light.received.row(point);
      float* last = light.lastBounce.row(point);
      for (std::size_t column = 0; column < light.layout.columns(); ++column)
        last[column] = all[column] - last[column];
    }
  LightRows sent(prepared.scene.mesh.positions.size(), light.layout.columns());
  sendBack(prepared.scene, prepared.topology, light.layout, isCounted ? light.lastBounce : light.received,
           sent);
  return sent;
}

}  // namespace

FittedBake bakeFitted(const PreparedScene& prepared, const ShadowedOptions& shadowed,
                      const FittedOptions& options, const ProgressCallback& progress) {
  const Scene& scene = prepared.scene;
  assert(!scene.emits());
  SampledBake sampled(prepared, options.samples, progress);
  const std::vector<Vec3f> white(scene.albedo.size(), Vec3f{1, 1, 1});
  FittedBake fitted;
  fitted.bake = bakeShadowed(prepared, white, shadowed, sampled.vertexProgress());
  std::vector<float> start = std::move(fitted.bake.transfer.values);
  fitted.bake.transfer = makeTransfer(scene.albedo, shadowed.degree);

  const Stopwatch watch;
  SampleTransfer measured =
      bakeSamples(prepared, sampled.samples, shadowed, sampled.sampleProgress(fitted.bake.statistics.rays));
  fitted.sampleSeconds = watch.seconds();
  const LightLayout layout{1, coefficientCount(shadowed.degree), false};
  fitReceived(prepared, layout, sampled.samples, measured, std::move(start), options.fit, fitted);
  return fitted;
}

FittedBake bakeFitted(const Scene& scene, const ShadowedOptions& shadowed, const FittedOptions& options,
                      const ProgressCallback& progress) {
  return bakeFitted(PreparedScene(scene), shadowed, options, progress);
}

FittedBake bakeFittedInterreflected(const PreparedScene& prepared,
                                    const InterreflectedOptions& interreflected, const FittedOptions& options,
                                    const ProgressCallback& progress) {
  SampledBake sampled(prepared, options.samples, progress);
  FittedBake fitted;
  BakeStatistics& statistics = fitted.bake.statistics;
  statistics.buildSeconds = prepared.buildSeconds;
  LightSolution light = solveLight(prepared, interreflected, sampled.vertexProgress(), statistics);
  fitted.bake.transfer =
      makeTransfer(light.layout.channels, prepared.scene.albedo.size(), interreflected.degree);

  const Stopwatch watch;
  const LightRows sent = sentToSamples(prepared, light, interreflected.bounces.has_value());
  SampleTransfer measured = gatherSamples(
      prepared, sampled.samples,
      {.degree = interreflected.degree, .rays = interreflected.rays, .seed = interreflected.seed},
      light.layout, sent, sampled.sampleProgress(statistics.rays));
  fitted.sampleSeconds = watch.seconds();
  fitReceived(prepared, light.layout, sampled.samples, measured,
              atVertices(prepared.topology, light.layout, light.received), options.fit, fitted);
  return fitted;
}

FittedBake bakeFittedInterreflected(const Scene& scene, const InterreflectedOptions& interreflected,
                                    const FittedOptions& options, const ProgressCallback& progress) {
  return bakeFittedInterreflected(PreparedScene(scene), interreflected, options, progress);
}

}  // namespace shprt
