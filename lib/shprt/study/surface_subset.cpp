#include "shprt/study/surface_subset.h"

#include <algorithm>

#include "shprt/sampling/random.h"

namespace shprt {

std::vector<std::uint32_t> spreadVertices(const Scene& scene, std::size_t count, std::uint64_t seed) {
  std::vector<std::uint32_t> receivers;
  for (std::uint32_t vertex = 0; vertex < scene.mesh.positions.size(); ++vertex)
    if (scene.isReceiver(vertex)) receivers.push_back(vertex);
  if (receivers.size() <= count) return receivers;
  std::vector<std::uint32_t> vertices;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = (static_cast<double>(i) + uniformRandom(seed, i, 0)) / static_cast<double>(count);
    const auto place = static_cast<std::size_t>(share * static_cast<double>(receivers.size()));
    vertices.push_back(receivers[std::min(place, receivers.size() - 1)]);
  }
  return vertices;
}

std::vector<SurfaceSample> spreadSamples(const Scene& scene, const SurfaceTopology& topology,
                                         std::size_t count, std::uint64_t seed) {
  std::vector<std::uint32_t> triangles;
  std::vector<double> ends;  // area up to and with each
  double area = 0;
  for (std::uint32_t triangle = 0; triangle < topology.triangles().size(); ++triangle) {
    if (!scene.isReceiver(topology.triangles()[triangle][0])) continue;
    triangles.push_back(triangle);
    ends.push_back(area += triangleArea(topology, triangle));
  }
  std::vector<SurfaceSample> samples;
  if (!(area > 0)) return samples;
  for (std::size_t i = 0; i < count; ++i) {
    const double at =
        area * (static_cast<double>(i) + uniformRandom(seed, i, 0)) / static_cast<double>(count);
    const auto place =
        static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), at) - ends.begin());
    double u = uniformRandom(seed, i, 1), v = uniformRandom(seed, i, 2);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    samples.push_back({triangles[std::min(place, triangles.size() - 1)], static_cast<float>(u),
                       static_cast<float>(v), area / static_cast<double>(count)});
  }
  return samples;
}

}  // namespace shprt
