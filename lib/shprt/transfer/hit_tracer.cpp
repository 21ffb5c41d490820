#include "shprt/transfer/hit_tracer.h"

#include <optional>
#include <utility>

namespace shprt {

HitTracer::HitTracer(const Scene& scene, const FrontFaces& fronts, HemisphereTracer tracer)
    : scene_(scene), fronts_(fronts), textured_(!scene.textures.empty()), tracer_(std::move(tracer)) {}

RayEnds HitTracer::trace(std::size_t point, BlockHits& hits) {
  const std::size_t firstHit = hits.hits.size(), firstAlbedo = hits.albedo.size();
  hits.quarterEnds.push_back({});
  tracer_.traceHits(point);
  RayEnds ends = sortRays(hits);
  // Once around, and back to the first step where none is better.
  const std::size_t steps = ends.mayBeBuried() ? tracer_.stepCount() : 1;
  for (std::size_t next = 1; ends.mayBeBuried() && steps > 1 && next <= steps; ++next) {
    hits.hits.resize(firstHit);
    hits.albedo.resize(firstAlbedo);
    tracer_.traceHitsFrom(next % steps);
    ends = sortRays(hits);
  }
  hits.ends.push_back(static_cast<std::uint32_t>(hits.hits.size()));
  return ends;
}

RayEnds HitTracer::sortRays(BlockHits& hits) const {
  RayEnds ends{.sky = tracer_.visible()};
  for (unsigned quarter = 0; quarter < 4; ++quarter) {
    sortQuarter(quarter, ends, hits);
    if (quarter < 3) hits.quarterEnds.back()[quarter] = static_cast<std::uint32_t>(hits.hits.size());
  }
  return ends;
}

void HitTracer::sortQuarter(unsigned quarter, RayEnds& ends, BlockHits& hits) const {
  const std::span<const std::uint8_t> quarters = tracer_.quarters();
  for (std::size_t ray = 0; ray < tracer_.rays(); ++ray) {
    if (quarters[ray] != quarter || tracer_.seesSky(ray)) continue;
    const std::optional<SurfacePoint> front = fronts_.facing(tracer_.hit(ray), tracer_.direction(ray));
    if (!front) {
      ++ends.backs;
      continue;
    }
    ++ends.fronts;
    hits.hits.push_back(CompactHit::from(*front));
    if (textured_)
      hits.albedo.push_back(CompactAlbedo::from(scene_.albedoAt(front->triangle, front->u, front->v)));
  }
}

}  // namespace shprt
