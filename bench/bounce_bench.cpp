// What all bounces cost beside the rays that they reuse, and what the interreflected model's trace (nearest
// hits, kept) costs beside the shadowed model's (any hit). Usage: bench_bounce [MESH] [RAYS] [benchmark
// options]; the default mesh is the shared Stanford bunny, else data/knot.ply. Degree 4, albedo 0.8, bounces
// to an error of 1%.

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "bench/ratio.h"
#include "shprt/mesh/load_mesh.h"
#include "shprt/transfer/bake.h"

int main(int argc, char** argv) {
  using namespace shprt;
  std::filesystem::path path = SHPRT_SHARED_DIR "/data/meshes/stanford-bunny.obj";
  int rays = 256;
  if (argc > 1 && argv[1][0] != '-') path = argv[1];
  if (argc > 2 && argv[2][0] != '-') rays = std::max(1, std::atoi(argv[2]));
  if (!std::filesystem::exists(path)) path = SHPRT_SOURCE_DIR "/data/knot.ply";
  const Mesh mesh = loadMesh(path).mesh;
  const std::vector<Vec3f> grey(mesh.positions.size(), Vec3f{0.8f, 0.8f, 0.8f});
  std::vector<Vec3f> coloured = grey;
  coloured.front() = {0.8f, 0.8f, 0.7f};
  const Scene greyScene = makeScene(mesh, grey), colouredScene = makeScene(mesh, coloured);
  std::printf("%s: %zu vertices, %zu triangles, %d rays per vertex\n", path.c_str(), mesh.positions.size(),
              mesh.triangles.size(), rays);

  // One bake tells both times; each benchmark reports its share.
  const auto configure = [](benchmark::internal::Benchmark* b) {
    b->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(1)->Repetitions(7);
  };
  const auto registerShare = [&](const char* name, const Scene& scene, double BakeStatistics::*seconds) {
    configure(benchmark::RegisterBenchmark(name, [&scene, rays, seconds](benchmark::State& state) {
      for (auto _ : state) {
        const Bake bake = bakeInterreflected(scene, {.degree = 4, .rays = rays, .seed = 1});
        state.SetIterationTime(bake.statistics.*seconds);
        state.counters["bounces"] = static_cast<double>(bake.statistics.bounces.size());
        state.counters["bounces/trace"] = bake.statistics.bounceSeconds / bake.statistics.traceSeconds;
        state.counters["hits"] = static_cast<double>(bake.statistics.hits);
      }
    }));
  };
  registerShare("trace_grey", greyScene, &BakeStatistics::traceSeconds);
  registerShare("bounces_grey", greyScene, &BakeStatistics::bounceSeconds);
  registerShare("trace_colour", colouredScene, &BakeStatistics::traceSeconds);
  registerShare("bounces_colour", colouredScene, &BakeStatistics::bounceSeconds);
  configure(benchmark::RegisterBenchmark("trace_shadowed", [&](benchmark::State& state) {
    for (auto _ : state) {
      const Bake bake = bakeShadowed(greyScene, {.degree = 4, .rays = rays, .seed = 1});
      state.SetIterationTime(bake.statistics.traceSeconds);
    }
  }));
  return bench::runWithRatios(argc, argv,
                              {{"bounces_grey", "trace_grey", 0.15},
                               {"bounces_colour", "trace_colour", 0.15},
                               {"trace_grey", "trace_shadowed", 1.6}});
}
