// One row of the transport operator times light: what a point receives from where its rays end.
#pragma once

#include <span>
#include <vector>

#include "shprt/mesh/mesh.h"
#include "shprt/transfer/hit_store.h"
#include "shprt/transfer/light_rows.h"

namespace shprt {

// For the points of one block; buffers are kept. The arguments must outlive it.
class HitGatherer {
 public:
  // sources: a row per render vertex, which is interpolated inside triangles.
  HitGatherer(const LightLayout& layout, const LightRows& sources, std::span<const Triangle> triangles);

  // Writes the mean over `rays` rays, of which these hit, of the sources where they end, times the albedo
  // there if there is one per hit (else none). Sums are of fixed order: sixteen hits in float, those in
  // double.
  void gather(std::span<const CompactHit> hits, std::span<const CompactAlbedo> albedo, std::size_t rays,
              float* row);

 private:
  void addHit(const CompactHit& hit, float* sums) const;
  void addHit(const CompactHit& hit, const CompactAlbedo& albedo, float* sums);

  const LightLayout& layout_;
  const LightRows& sources_;
  std::span<const Triangle> triangles_;
  std::vector<float> partial_, interpolated_;
  std::vector<double> sums_;
};

}  // namespace shprt
