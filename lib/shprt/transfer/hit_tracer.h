// A point's rays sorted by what they meet: the sky, fronts (kept as hits), or backs.
#pragma once

#include "shprt/scene/scene.h"
#include "shprt/transfer/buried_search.h"
#include "shprt/transfer/front_faces.h"
#include "shprt/transfer/hemisphere_tracer.h"
#include "shprt/transfer/hit_store.h"

namespace shprt {

// For the points of one block. The arguments must outlive it.
class HitTracer {
 public:
  HitTracer(const Scene& scene, const FrontFaces& fronts, HemisphereTracer tracer);

  // Traces the rays of the block's next point and appends its hits, quarter after quarter. They start
  // where the sky is seen (hemisphere_tracer.h) or, where it is not, at the first of the point's steps that
  // cannot be buried. Where all of them may be, so may the point.
  RayEnds trace(std::size_t point, BlockHits& hits);
  // Appends a point without hits.
  static void skip(BlockHits& hits) {
    const auto end = static_cast<std::uint32_t>(hits.hits.size());
    hits.ends.push_back(end);
    hits.quarterEnds.push_back({end, end, end});
  }

  const HemisphereTracer& rays() const { return tracer_; }  // of the point traced last

 private:
  RayEnds sortRays(BlockHits& hits) const;
  void sortQuarter(unsigned quarter, RayEnds& ends, BlockHits& hits) const;

  const Scene& scene_;
  const FrontFaces& fronts_;
  bool textured_;
  HemisphereTracer tracer_;
};

}  // namespace shprt
