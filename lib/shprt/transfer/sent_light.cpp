#include "shprt/transfer/sent_light.h"

#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {

LightLayout lightLayout(const Scene& scene, int degree) {
  return {isGrey(scene) ? 1 : 3, coefficientCount(degree), scene.emits()};
}

void sendBack(const Scene& scene, const SurfaceTopology& topology, const LightLayout& layout,
              const LightRows& received, LightRows& sent) {
  const bool textured = !scene.textures.empty();
  parallelForBlocks(sent.rows(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t vertex = begin; vertex < end; ++vertex) {
      const float* in = received.row(topology.pointIds()[vertex]);
      float* out = sent.row(vertex);
      const Vec3f albedo = textured ? Vec3f{1, 1, 1} : scene.albedo[vertex];
      const float channelAlbedo[3] = {albedo.x, albedo.y, albedo.z};
      for (int i = 0; i < layout.bandCount(); ++i) {
        const LightLayout::Band band = layout.band(i);
        for (std::size_t column = band.first; column < band.end; ++column)
          out[column] = channelAlbedo[band.albedoChannel] * in[column];
      }
    }
  });
}

Vec3f meanEmission(const Scene& scene, std::span<const CompactHit> hits, std::size_t rays) {
  Vec3d sum;
  for (const CompactHit& hit : hits) sum += toDouble(scene.materialOf(hit.triangle).emission);
  return toFloat(sum / static_cast<double>(rays));
}

}  // namespace shprt
