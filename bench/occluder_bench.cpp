// What bounds on occluders cost and spare: building them, and whole shadowed bakes with and without them.
// Where little is unoccluded, the ratio is what planning costs. Usage: bench_occluder [benchmark options].

#include <filesystem>
#include <list>

#include "bench/ratio.h"
#include "shprt/mesh/load_mesh.h"
#include "shprt/scene/occluder_bounds.h"
#include "shprt/scene/scene_frame.h"
#include "shprt/transfer/bake.h"

int main(int argc, char** argv) {
  using namespace shprt;
  const std::pair<std::string, std::filesystem::path> meshes[] = {
      {"convex", SHPRT_SHARED_DIR "/data/meshes/box_new.obj"},
      {"knot", SHPRT_SOURCE_DIR "/data/knot.ply"},
      {"courtyard", SHPRT_SOURCE_DIR "/data/courtyard.obj"},
      {"bunny", SHPRT_SHARED_DIR "/data/meshes/stanford-bunny.obj"},
      {"armadillo", SHPRT_SHARED_DIR "/data/meshes/armadillo.obj"},
      {"fandisk", SHPRT_SHARED_DIR "/data/meshes/fandisk.obj"},
      {"sponza", SHPRT_SHARED_DIR "/data/meshes/sponza.obj"}};
  const auto configure = [](benchmark::internal::Benchmark* b) {
    b->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Repetitions(7);
  };
  std::list<Scene> scenes;
  std::list<std::vector<Vec3f>> framed;
  std::vector<bench::Ratio> ratios;
  for (const auto& [name, path] : meshes) {
    if (!std::filesystem::exists(path)) continue;
    Mesh mesh = loadMesh(path).mesh;
    std::vector<Vec3f> albedo(mesh.positions.size(), Vec3f{0.8f, 0.8f, 0.8f});
    const Scene& scene = scenes.emplace_back(makeScene(std::move(mesh), std::move(albedo)));
    const std::vector<Vec3f>& positions =
        framed.emplace_back(toScene(chooseSceneFrame(scene.mesh.positions), scene.mesh.positions));
    configure(benchmark::RegisterBenchmark((name + "_build").c_str(), [&](benchmark::State& state) {
      for (auto _ : state) benchmark::DoNotOptimize(OccluderBounds(positions, scene.mesh.triangles));
    }));
    for (const bool everything : {true, false}) {
      const std::string which = name + (everything ? "_traced" : "_bounded");
      configure(benchmark::RegisterBenchmark(which.c_str(), [&scene, everything](benchmark::State& state) {
        BakeStatistics statistics;
        for (auto _ : state)
          statistics =
              bakeShadowed(scene, {.degree = 4, .rays = 256, .seed = 1, .traceEverything = everything})
                  .statistics;
        state.counters["spared"] =
            static_cast<double>(statistics.raysSpared) / static_cast<double>(statistics.rays);
        state.counters["unoccluded"] =
            static_cast<double>(statistics.unoccludedPoints) / static_cast<double>(statistics.samplePoints);
      }));
    }
    ratios.push_back({name + "_bounded", name + "_traced", 1.05});
  }
  return bench::runWithRatios(argc, argv, ratios);
}
