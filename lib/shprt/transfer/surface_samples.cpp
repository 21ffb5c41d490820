#include "shprt/transfer/surface_samples.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "shprt/sampling/random.h"

namespace shprt {
namespace {

// The i-th point of a triangle that is to hold `count`, as barycentrics. A part of the triangle is its corner
// (u, v) and a size, negative where it stands upside down.
Vec2f pointInTriangle(std::uint64_t triangleSeed, std::uint32_t i, std::uint32_t count) {
  double u = 0, v = 0, size = 1;
  std::uint64_t part = 1;  // the digits so far, after a leading 1
  for (std::uint64_t parts = 1, digits = i; parts < count; parts *= 4, digits /= 4) {
    const std::uint64_t digit = (digits ^ hashCounter(triangleSeed, 4 * part)) % 4;
    part = 4 * part + digits % 4;
    size /= 2;
    if (digit == 0 || digit == 1) u += size;
    if (digit == 0 || digit == 2) v += size;
    if (digit == 0) size = -size;
  }
  double a = uniformRandom(~triangleSeed, i, 0), b = uniformRandom(~triangleSeed, i, 1);
  if (a + b > 1) a = 1 - a, b = 1 - b;
  return {static_cast<float>(u + size * a), static_cast<float>(v + size * b)};
}

}  // namespace

double triangleArea(const SurfaceTopology& topology, std::uint32_t triangle) {
  const auto& [a, b, c] = topology.triangles()[triangle];
  const Vec3d corner = toDouble(topology.positions()[a]);
  return 0.5 * length(cross(toDouble(topology.positions()[b]) - corner,
                            toDouble(topology.positions()[c]) - corner));
}

std::vector<SurfaceSample> sampleSurface(const Scene& scene, const SurfaceTopology& topology,
                                         const SampleOptions& options) {
  assert(options.perTriangle > 0 && options.minimum >= 1);
  const std::span<const Triangle> triangles = topology.triangles();
  std::vector<double> areas(triangles.size());
  double totalArea = 0, receivers = 0;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!scene.isReceiver(triangles[t][0])) continue;
    areas[t] = triangleArea(topology, t);
    totalArea += areas[t];
    ++receivers;
  }
  std::vector<SurfaceSample> samples;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!scene.isReceiver(triangles[t][0])) continue;
    const double share = totalArea > 0 ? areas[t] / totalArea : 0;
    const auto count = static_cast<std::uint32_t>(std::max<double>(
        options.minimum, std::round(std::min(1e9, options.perTriangle * receivers * share))));
    const std::uint64_t triangleSeed = hashCounter(options.seed, t);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec2f point = pointInTriangle(triangleSeed, i, count);
      samples.push_back({t, point.x, point.y, areas[t] / count});
    }
  }
  return samples;
}

void removeSamples(std::span<const std::uint32_t> which, std::vector<SurfaceSample>& samples,
                   SampleValues& values) {
  std::size_t kept = 0;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (!which.empty() && which.front() == s) {
      which = which.subspan(1);
      continue;
    }
    samples[kept] = samples[s];
    std::copy_n(values.values.begin() + static_cast<std::ptrdiff_t>(s * values.rows), values.rows,
                values.values.begin() + static_cast<std::ptrdiff_t>(kept * values.rows));
    ++kept;
  }
  samples.resize(kept);
  values.values.resize(kept * values.rows);
}

}  // namespace shprt
