// Transfer of a diffuse surface that nothing shadows: the clamped cosine around the normal.
// Based on: Ramamoorthi and Hanrahan 2001, eqs. 5-9, divided by pi and times albedo.

#include <algorithm>
#include <cassert>
#include <numbers>

#include "shprt/base/parallel.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {

Bake bakeUnshadowed(const Mesh& mesh, std::span<const Vec3f> albedo, int degree) {
  assert(albedo.size() == mesh.positions.size());
  Bake bake;
  bake.transfer = makeTransfer(albedo, degree);
  const UnshadowedTransfer unshadowed(degree);
  parallelForBlocks(mesh.positions.size(), 1024, [&](std::size_t begin, std::size_t end) {
    std::vector<double> transfer(static_cast<std::size_t>(coefficientCount(degree)));
    for (std::size_t vertex = begin; vertex < end; ++vertex) {
      unshadowed.evaluate(normalize(toDouble(mesh.normals[vertex])), transfer);
      storeTransfer(transfer, albedo[vertex], vertex, bake.transfer);
    }
  });
  bake.statistics.fullyVisible = mesh.positions.size();
  bake.statistics.samplePoints = mesh.positions.size();
  return bake;
}

}  // namespace shprt
