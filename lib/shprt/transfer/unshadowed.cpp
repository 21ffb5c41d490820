// Transfer of a diffuse surface that nothing shadows: the clamped cosine around the normal.
// Based on: Ramamoorthi and Hanrahan 2001, eqs. 5-9, divided by pi and times albedo.

#include <algorithm>
#include <atomic>
#include <cassert>
#include <numbers>

#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {

Bake bakeUnshadowed(const Scene& scene, int degree) {
  const Mesh& mesh = scene.mesh;
  assert(scene.albedo.size() == mesh.positions.size());
  Bake bake;
  bake.transfer = makeTransfer(scene.albedo, degree);
  const UnshadowedTransfer unshadowed(degree);
  std::atomic<std::uint64_t> baked = 0;
  parallelForBlocks(mesh.positions.size(), 1024, [&](std::size_t begin, std::size_t end) {
    std::vector<double> transfer(static_cast<std::size_t>(coefficientCount(degree)));
    for (std::size_t i = begin; i < end; ++i) {
      const auto vertex = static_cast<std::uint32_t>(i);
      if (!scene.isReceiver(vertex)) continue;
      unshadowed.evaluate(normalize(toDouble(mesh.normals[vertex])), transfer);
      storeTransfer(transfer, scene.albedo[vertex], vertex, bake.transfer);
      ++baked;
    }
  });
  if (scene.emits()) bake.emission = ownEmission(scene);
  bake.statistics.fullyVisible = baked;
  bake.statistics.samplePoints = baked;
  return bake;
}

}  // namespace shprt
