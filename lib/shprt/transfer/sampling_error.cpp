#include "shprt/transfer/sampling_error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <span>

#include "shprt/transfer/edge_smoothing.h"

namespace shprt {
namespace {

constexpr double kNormalQuantile = 1.645;  // one-sided 95%
constexpr int kSmoothings = 2;

float channelOf(Vec3f colour, int channel) {
  return channel == 0 ? colour.x : channel == 1 ? colour.y : colour.z;
}

double channelOf(Vec3d colour, int channel) {
  return channel == 0 ? colour.x : channel == 1 ? colour.y : colour.z;
}

double squareOf(Vec3f colour) {
  const Vec3d exact = toDouble(colour);
  return dot(exact, exact);
}

double weightOf(const ErrorLayout& layout, Vec3d weight, int channel) {
  return layout.channels == 1 ? weight.x + weight.y + weight.z : channelOf(weight, channel);
}

}  // namespace

std::vector<Vec3d> pointWeights(const Scene& scene, const SurfaceTopology& topology) {
  std::vector<Vec3d> weights(topology.pointCount());
  for (std::uint32_t vertex = 0; vertex < scene.albedo.size(); ++vertex) {
    if (!scene.isReceiver(vertex)) continue;
    const Vec3d albedo = toDouble(scene.albedo[vertex]);
    weights[topology.pointIds()[vertex]] +=
        Vec3d{albedo.x * albedo.x, albedo.y * albedo.y, albedo.z * albedo.z};
  }
  return weights;
}

double weightedSquare(const PointErrors& errors, const LightRows& squares, std::size_t point, Vec3d weight) {
  const ErrorLayout& layout = errors.layout;
  double sum = 0;
  for (int channel = 0; channel < layout.channels; ++channel) {
    double square = 0;
    for (int band = 0; band <= layout.degree; ++band)
      square += static_cast<double>(squares.row(point)[layout.column(channel, band)]);
    sum += weightOf(layout, weight, channel) * square;
  }
  return sum;
}

double toVariances(std::span<const Vec3d> weights, PointErrors& errors) {
  struct Evidence {
    double quarters = 0, sixteenths = 0;
    double ratio() const { return quarters > 0 ? std::clamp(sixteenths / quarters, 4.0, kSafeRatio) : 4.0; }
  };
  std::array<Evidence, 33> byRays;
  Evidence all;
  for (std::size_t point = 0; point < weights.size(); point += kRateStride) {
    const double weight = weights[point].x + weights[point].y + weights[point].z;
    for (Evidence* evidence : {&all, &byRays[static_cast<std::size_t>(std::bit_width(errors.rays[point]))]}) {
      evidence->quarters += weight * static_cast<double>(errors.quarters[point]);
      evidence->sixteenths += weight * static_cast<double>(errors.sixteenths[point]);
    }
  }
  for (std::size_t point = 0; point < weights.size(); ++point) {
    const double ratio = byRays[static_cast<std::size_t>(std::bit_width(errors.rays[point]))].ratio();
    for (std::size_t column = 0; column < errors.squares.stride(); ++column)
      errors.squares.row(point)[column] *= static_cast<float>(1 / (ratio - 1));
  }
  return std::log2(all.ratio()) / 2;
}

void measureSamplingError(const PointErrors& errors, std::span<const Vec3d> weights, double unshadowedSquare,
                          SamplingStatistics& statistics) {
  double weightSum = 0, sum = 0, squares = 0, count = 0;
  for (std::size_t point = 0; point < weights.size(); ++point) {
    const Vec3d weight = weights[point];
    weightSum += weight.x + weight.y + weight.z;
    if (errors.rays[point] == 0) continue;
    const double term = weightedSquare(errors, errors.squares, point, weight);
    sum += term, squares += term * term, count += 1;
  }
  statistics.measured = true;
  if (!(weightSum > 0) || count == 0) return;
  const double unit = 1 / (weightSum * unshadowedSquare);
  const double deviation = std::sqrt(std::max(squares - sum * sum / count, 0.0));
  statistics.error = std::sqrt(unit * sum);
  statistics.errorBound = std::sqrt(unit * (sum + kNormalQuantile * deviation));
}

LightRows smoothVariances(const PointErrors& errors, const SurfaceTopology& topology, double exponent) {
  LightRows rows = errors.squares;
  for (std::size_t point = 0; point < rows.rows(); ++point) {
    const auto scale = static_cast<float>(std::pow(static_cast<double>(errors.rays[point]), exponent));
    for (std::size_t column = 0; column < rows.stride(); ++column) rows.row(point)[column] *= scale;
  }
  std::vector<std::uint8_t> isExact(rows.rows());
  for (std::size_t point = 0; point < isExact.size(); ++point) isExact[point] = errors.rays[point] == 0;
  smoothOverEdges(topology, isExact, kSmoothings, rows.stride(),
                  std::span(rows.row(0), rows.rows() * rows.stride()));
  return rows;
}

void storeErrors(const PointErrors& errors, const LightRows& variances, double exponent, const Scene& scene,
                 const SurfaceTopology& topology, Bake& bake) {
  const ErrorLayout& layout = errors.layout;
  TransferError& error = bake.error;
  error.degree = bake.transfer.degree;
  error.channels = bake.transfer.channels;
  error.vertexCount = bake.transfer.vertexCount;
  error.values.assign(static_cast<std::size_t>(error.channels * error.bands()) * error.vertexCount, 0.0f);
  if (layout.emission) bake.emissionError.assign(error.vertexCount, Vec3f{});
  double emissionSquare = 0, emissionErrorSquare = 0;
  for (std::uint32_t vertex = 0; vertex < error.vertexCount; ++vertex) {
    const std::uint32_t point = topology.pointIds()[vertex];
    if (!scene.isReceiver(vertex)) continue;
    if (layout.emission) emissionSquare += squareOf(bake.emission[vertex]);
    if (errors.rays[point] == 0) continue;
    const double scale = std::pow(static_cast<double>(errors.rays[point]), -exponent);
    const auto deviation = [&](std::size_t column, int channel) {
      return channelOf(scene.albedo[vertex], channel) *
             static_cast<float>(std::sqrt(scale * static_cast<double>(variances.row(point)[column])));
    };
    for (int channel = 0; channel < error.channels; ++channel)
      for (int band = 0; band < error.bands(); ++band)
        error.row(channel, band)[vertex] =
            deviation(layout.column(std::min(channel, layout.channels - 1), band), channel);
    if (!layout.emission) continue;
    const std::size_t first = layout.emissionColumn();
    bake.emissionError[vertex] = {deviation(first, 0), deviation(first + 1, 1), deviation(first + 2, 2)};
    emissionErrorSquare += squareOf(bake.emissionError[vertex]);
  }
  if (emissionSquare > 0)
    bake.statistics.sampling.emissionError = std::sqrt(emissionErrorSquare / emissionSquare);
}

void countRays(const PointErrors& errors, const Scene& scene, const SurfaceTopology& topology,
               SamplingStatistics& statistics) {
  std::map<std::uint32_t, std::uint64_t> counts;
  double rays = 0, vertices = 0;
  for (std::uint32_t vertex = 0; vertex < scene.albedo.size(); ++vertex) {
    if (!scene.isReceiver(vertex)) continue;
    const std::uint32_t count = errors.rays[topology.pointIds()[vertex]];
    ++counts[count];
    rays += count, vertices += 1;
  }
  statistics.raysPerVertex = vertices > 0 ? rays / vertices : 0;
  const bool isUniform = counts.size() <= (counts.count(0) ? 2u : 1u);
  std::map<int, std::uint64_t> bins;
  for (const auto& [count, number] : counts) {
    const double nearest = count == 0 ? 0 : std::exp2(std::round(std::log2(static_cast<double>(count))));
    bins[isUniform ? static_cast<int>(count) : static_cast<int>(nearest)] += number;
  }
  statistics.verticesByRays.assign(bins.begin(), bins.end());
}

}  // namespace shprt
