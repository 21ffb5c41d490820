// RMS error of shadowed transfer against rays per vertex: the lattice that bakes use, and plain random
// directions. Error is the RMS over vertices of the coefficient error's 2-norm, over the RMS of the
// unshadowed transfer's norm; the reference is a bake of 65,536 rays with another seed. Prints a Markdown
// table; times nothing. Usage: bench_sampling_error [MESH] [DEGREE] [REFERENCE_RAYS]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "shprt/base/frame.h"
#include "shprt/base/parallel.h"
#include "shprt/mesh/load_mesh.h"
#include "shprt/sampling/hemisphere.h"
#include "shprt/sampling/random.h"
#include "shprt/scene/ray_caster.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/local_horizon.h"
#include "shprt/transfer/surface_topology.h"
#include "shprt/transfer/transfer_rows.h"

namespace {

using namespace shprt;

TransferCoefficients bakeRandom(const Mesh& mesh, std::span<const Vec3f> albedo, int degree, int rays) {
  const SurfaceTopology topology(mesh);
  const RayCaster caster(topology.positions(), topology.triangles());
  TransferCoefficients transfer = makeTransfer(albedo, degree);
  parallelForBlocks(mesh.positions.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<double> sum(static_cast<std::size_t>(coefficientCount(degree))), y(sum.size());
    LocalHorizon horizon;
    for (std::size_t vertex = begin; vertex < end; ++vertex) {
      const auto v = static_cast<std::uint32_t>(vertex);
      horizon.prepare(topology, v, {});
      const Frame frame = frameFromNormal(topology.normal(v));
      std::fill(sum.begin(), sum.end(), 0.0);
      for (int first = 0; first < rays; first += kRayPacketSize) {
        Vec3d d[kRayPacketSize];
        float x[kRayPacketSize], dy[kRayPacketSize], z[kRayPacketSize];
        for (int lane = 0; lane < kRayPacketSize; ++lane) {
          const auto counter = vertex * 65536 + static_cast<std::size_t>(first + lane);
          d[lane] = frame.toWorld(
              sampleCosineHemisphere(uniformRandom(5, counter, 0), uniformRandom(5, counter, 1)));
          x[lane] = static_cast<float>(d[lane].x), dy[lane] = static_cast<float>(d[lane].y),
          z[lane] = static_cast<float>(d[lane].z);
        }
        const RayPacket packet{x, dy, z};
        std::uint32_t visible = 0xffff & ~horizon.hidden(packet);
        if (visible)
          visible &= ~caster.occluded(topology.positions()[vertex], packet, visible,
                                      {topology.trianglesAt(topology.positionIds()[vertex]),
                                       {},
                                       static_cast<float>(topology.contactDistance())});
        for (int lane = 0; lane < kRayPacketSize; ++lane) {
          if (!((visible >> lane) & 1u)) continue;
          evaluateSh(degree, d[lane], y);
          for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += y[i] / rays;
        }
      }
      storeTransfer(sum, albedo[vertex], vertex, transfer);
    }
  });
  return transfer;
}

double norm(const TransferCoefficients& a, const TransferCoefficients* b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double difference = static_cast<double>(a.values[i]) - (b ? static_cast<double>(b->values[i]) : 0);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : SHPRT_SOURCE_DIR "/data/knot.ply";
  const int degree = argc > 2 ? std::atoi(argv[2]) : 4;
  const int referenceRays = argc > 3 ? std::atoi(argv[3]) : 65536;
  const Mesh mesh = loadMesh(path).mesh;
  const Scene scene = makeScene(mesh, std::vector<Vec3f>(mesh.positions.size(), Vec3f{1, 1, 1}));
  const TransferCoefficients reference =
      bakeShadowed(scene, {.degree = degree, .rays = referenceRays, .seed = 999}).transfer;
  const double scale = norm(bakeUnshadowed(scene, degree).transfer, nullptr);
  std::printf(
      "%s, %zu vertices, degree %d, reference %d rays\n\n| rays | lattice | random |\n|---|---|---|\n",
      path.c_str(), mesh.positions.size(), degree, referenceRays);
  for (const int rays : {16, 64, 256, 1024, 4096}) {
    const TransferCoefficients lattice =
        bakeShadowed(scene, {.degree = degree, .rays = rays, .seed = 1}).transfer;
    const TransferCoefficients random = bakeRandom(mesh, scene.albedo, degree, rays);
    std::printf("| %d | %.2g | %.2g |\n", rays, norm(lattice, &reference) / scale,
                norm(random, &reference) / scale);
    std::fflush(stdout);
  }
}
