// Transfer of diffuse surfaces under shadows and light that bounces between them: the shadowed transfer and
// its bounces (light_transport.h), summed, times the vertex's albedo.
//
// The scene's own lights come along as three more numbers per vertex: what arrives from emitters, and bounces
// like the rest.
//
// Memory beside Embree's: three sets of rows (light at points, what vertices send back, the sum), each of 64
// bytes for every 16 numbers of coefficients times channels; and 8 bytes for every ray that meets a front, 14
// in textured scenes, up to options.hitMemory.

#include "shprt/base/parallel.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/light_solution.h"
#include "shprt/transfer/stopwatch.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {
namespace {

// Albedo times what vertices receive.
void storeLight(const PreparedScene& prepared, const LightSolution& light, int degree, Bake& bake) {
  const Scene& scene = prepared.scene;
  const LightLayout& layout = light.layout;
  bake.transfer = makeTransfer(layout.channels, scene.mesh.positions.size(), degree);
  if (layout.emission) bake.emission = ownEmission(scene);
  parallelForBlocks(scene.mesh.positions.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto vertex = static_cast<std::uint32_t>(i);
      if (!scene.isReceiver(vertex)) continue;
      const Vec3f albedo = scene.albedo[vertex];
      const float channelAlbedo[3] = {albedo.x, albedo.y, albedo.z};
      const float* row = light.received.row(prepared.topology.pointIds()[vertex]);
      for (int channel = 0; channel < layout.channels; ++channel)
        for (int k = 0; k < layout.coefficients; ++k)
          bake.transfer.row(channel, k)[vertex] =
              channelAlbedo[channel] * row[channel * layout.coefficients + k];
      if (!layout.emission) continue;
      const float* emission = row + layout.emissionColumn();
      bake.emission[vertex] += Vec3f{albedo.x * emission[0], albedo.y * emission[1], albedo.z * emission[2]};
    }
  });
}

}  // namespace

Bake bakeInterreflected(const PreparedScene& prepared, const InterreflectedOptions& options,
                        const ProgressCallback& progress) {
  Bake bake;
  const LightSolution light = solveLight(prepared, options, progress, bake.statistics);
  const Stopwatch watch;
  storeLight(prepared, light, options.degree, bake);
  bake.statistics.bounceSeconds += watch.seconds();
  bake.statistics.buildSeconds = prepared.buildSeconds;
  return bake;
}

Bake bakeInterreflected(const Scene& scene, const InterreflectedOptions& options,
                        const ProgressCallback& progress) {
  return bakeInterreflected(PreparedScene(scene), options, progress);
}

}  // namespace shprt
