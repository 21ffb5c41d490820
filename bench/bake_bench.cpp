// What a whole shadowed bake costs beside a bare Embree loop over the same rays.
// The bare loop builds its scene, makes the same directions, offsets origins by a fixed epsilon and keeps
// nothing but a count: no filter, no spherical harmonics. It runs with Embree's defaults, where rays may slip
// between neighbouring triangles, and in the robust mode that bakes use. Usage: bench_bake [MESH] [RAYS]
// [benchmark options]; the default mesh is the shared Stanford bunny, else data/knot.ply.

#include <tbb/parallel_for.h>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <utility>

#include "bench/ratio.h"
#include "shprt/mesh/load_mesh.h"
#include "shprt/sampling/fibonacci_hemisphere.h"
#include "shprt/scene/scene_frame.h"
#include "shprt/transfer/bake.h"

namespace {

using namespace shprt;

struct BareScene {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);

  BareScene(const std::vector<Vec3f>& positions, const std::vector<Triangle>& triangles,
            RTCSceneFlags flags) {
    rtcSetSceneFlags(scene, flags);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    std::memcpy(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, positions.size()),
        positions.data(), positions.size() * 12);
    std::memcpy(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles.size()),
        triangles.data(), triangles.size() * 12);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
  }
  ~BareScene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

void occludedSixteen(const int* valid, RTCScene scene, RTCRay16* ray) {
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded16(valid, scene, ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded16(valid, scene, &context, ray);
#endif
}

std::uint64_t traceBare(const Mesh& mesh, const std::vector<Vec3f>& positions,
                        const FibonacciHemisphere& lattice, RTCSceneFlags flags) {
  const BareScene bare(positions, mesh.triangles, flags);
  std::atomic<std::uint64_t> occluded = 0;
  tbb::parallel_for(std::size_t{0}, (positions.size() + 63) / 64, [&](std::size_t block) {
    alignas(64) int valid[16];
    std::fill(valid, valid + 16, -1);
    std::uint64_t hits = 0;
    const std::size_t rays = lattice.paddedCount();
    std::vector<float> x(rays), y(rays), z(rays);
    for (std::size_t v = block * 64; v < std::min(positions.size(), block * 64 + 64); ++v) {
      const Vec3f origin = positions[v] + mesh.normals[v] * 1e-4f;
      lattice.directions(normalize(toDouble(mesh.normals[v])), 1, v, x.data(), y.data(), z.data());
      for (std::size_t first = 0; first < rays; first += 16) {
        RTCRay16 ray;
        for (int lane = 0; lane < 16; ++lane) {
          ray.org_x[lane] = origin.x, ray.org_y[lane] = origin.y, ray.org_z[lane] = origin.z;
          ray.dir_x[lane] = x[first + static_cast<std::size_t>(lane)];
          ray.dir_y[lane] = y[first + static_cast<std::size_t>(lane)];
          ray.dir_z[lane] = z[first + static_cast<std::size_t>(lane)];
          ray.tnear[lane] = 0, ray.tfar[lane] = std::numeric_limits<float>::infinity();
          ray.time[lane] = 0, ray.mask[lane] = ~0u, ray.id[lane] = 0, ray.flags[lane] = 0;
        }
        occludedSixteen(valid, bare.scene, &ray);
        for (int lane = 0; lane < 16; ++lane) hits += ray.tfar[lane] < 0;
      }
    }
    occluded += hits;
  });
  return occluded;
}

}  // namespace

int main(int argc, char** argv) {
  std::filesystem::path path = SHPRT_SHARED_DIR "/data/meshes/stanford-bunny.obj";
  int rays = 256;
  if (argc > 1 && argv[1][0] != '-') path = argv[1];
  if (argc > 2 && argv[2][0] != '-') rays = std::max(16, std::atoi(argv[2]) / 16 * 16);
  if (!std::filesystem::exists(path)) path = SHPRT_SOURCE_DIR "/data/knot.ply";
  const Mesh mesh = loadMesh(path).mesh;
  const std::vector<Vec3f> positions = toScene(chooseSceneFrame(mesh.positions), mesh.positions);
  const Scene scene = makeScene(mesh, std::vector<Vec3f>(positions.size(), Vec3f{0.8f, 0.8f, 0.8f}));
  const FibonacciHemisphere lattice(rays, 16);
  std::printf("%s: %zu vertices, %zu triangles, %d rays per vertex\n", path.c_str(), positions.size(),
              mesh.triangles.size(), rays);

  const double allRays = static_cast<double>(positions.size()) * rays;
  const auto reportRays = [&](benchmark::State& state) {
    state.counters["rays/s"] = benchmark::Counter(allRays, benchmark::Counter::kIsIterationInvariantRate);
  };
  const auto configure = [](benchmark::internal::Benchmark* b) {
    b->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Repetitions(7);
  };
  for (const auto& [name, flags] : {std::pair("bare_embree", RTC_SCENE_FLAG_NONE),
                                    std::pair("bare_embree_robust", RTC_SCENE_FLAG_ROBUST)}) {
    configure(benchmark::RegisterBenchmark(name, [&, sceneFlags = flags](benchmark::State& state) {
      for (auto _ : state) benchmark::DoNotOptimize(traceBare(mesh, positions, lattice, sceneFlags));
      reportRays(state);
    }));
  }
  configure(benchmark::RegisterBenchmark("bake_shadowed", [&](benchmark::State& state) {
    for (auto _ : state)
      benchmark::DoNotOptimize(bakeShadowed(scene, {.degree = 4, .rays = rays, .seed = 1}));
    reportRays(state);
  }));
  return shprt::bench::runWithRatios(
      argc, argv, {{"bake_shadowed", "bare_embree", 1.3}, {"bake_shadowed", "bare_embree_robust", 1.3}});
}
