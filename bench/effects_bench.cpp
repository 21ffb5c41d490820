// What the effect plan saves: for every scene of data/ and ../shared/data/meshes the plan, a bake of what it
// calls for, a bake of everything, how long each took beside what was predicted, and how far the two differ
// in the error measure (docs/accuracy.md). Times are processor seconds over threads, so that other programs
// do not count. Writes the table of docs/effects.md. Usage: bench_effects [RAYS [ALBEDO [SCENE ...]]]; the
// default is 256 rays, the materials' albedo (-) and every mesh below 400,000 triangles.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/base/parallel.h"
#include "shprt/scene/load_scene.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/effect_plan.h"
#include "shprt/transfer/planned_bake.h"

namespace {

using namespace shprt;
constexpr int kDegree = 4;
constexpr double kError = 0.01;
constexpr std::size_t kMostTriangles = 400'000;

struct TimedBake {
  Bake bake;
  double seconds = 0;
};

// Processor seconds over threads: what the clock on the wall shows where nothing else runs.
double workSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC / threadCount();
}

template <typename Run>
TimedBake timed(const Run& run) {
  const double start = workSeconds();
  TimedBake result{run(), 0};
  result.seconds = workSeconds() - start;
  return result;
}

BakeRequest everything(int rays) {
  return {.degree = kDegree, .rays = rays, .error = kError, .traceEverything = true};
}

// RMS over receivers and channels of the 2-norm of the difference, over that of the unshadowed transfer with
// the same albedo.
double difference(const Scene& scene, const TransferCoefficients& a, const TransferCoefficients& b) {
  const TransferCoefficients bare = bakeUnshadowed(scene, a.degree).transfer;
  double squares = 0, reference = 0;
  for (int channel = 0; channel < 3; ++channel)
    for (int i = 0; i < a.rows(); ++i) {
      const auto rowOf = [&](const TransferCoefficients& t) {
        return t.row(std::min(channel, t.channels - 1), i);
      };
      const float *first = rowOf(a), *second = rowOf(b), *unshadowed = rowOf(bare);
      for (std::uint32_t v = 0; v < a.vertexCount; ++v) {
        if (!scene.isReceiver(v)) continue;
        const double off = static_cast<double>(first[v]) - static_cast<double>(second[v]);
        squares += off * off;
        reference += static_cast<double>(unshadowed[v]) * static_cast<double>(unshadowed[v]);
      }
    }
  return reference > 0 ? std::sqrt(squares / reference) : 0;
}

std::vector<std::filesystem::path> everyScene() {
  std::vector<std::filesystem::path> scenes;
  for (const char* folder : {SHPRT_SOURCE_DIR "/data", SHPRT_SHARED_DIR "/data/meshes"}) {
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      std::string suffix = entry.path().extension().string();
      std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                     [](unsigned char c) { return std::tolower(c); });
      const bool isMesh = suffix == ".obj" || suffix == ".ply" || suffix == ".off" || suffix == ".stl";
      // The meshes of cornell.json mean little apart.
      const bool isPart = entry.path().filename().string().starts_with("cornell_") &&
                          entry.path().parent_path() == SHPRT_SOURCE_DIR "/data";
      if ((isMesh && !isPart) || isSceneFile(entry.path())) scenes.push_back(entry.path());
    }
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

std::string neededIn(const EffectPlan& plan) {
  std::string names;
  for (const EffectFinding& finding : plan.findings) {
    if (!finding.needed || finding.effect == "degree") continue;
    names += (names.empty() ? "" : ", ") + finding.effect;
  }
  return names.empty() ? "nothing" : names;
}

void measure(const std::filesystem::path& path, int rays, std::optional<Vec3f> albedo) {
  const Scene scene = loadScene(path, {.creaseAngleDegrees = {}, .albedo = albedo});
  if (scene.mesh.triangles.size() > kMostTriangles) return;
  const double buildStart = workSeconds();
  const PreparedScene prepared(scene);
  const double start = workSeconds();
  const EffectPlan plan = planEffects(prepared, {}, {.degree = kDegree, .rays = rays, .error = kError});
  const double planSeconds = workSeconds() - start;
  const double predicted = plan.seconds - plan.buildSeconds + (start - buildStart);
  const TimedBake planned =
      timed([&] { return bakeRequested(prepared, followPlan(plan, {.rays = rays, .error = kError})); });
  const TimedBake all = timed([&] { return bakeRequested(prepared, everything(rays)); });
  const auto shown = [](double norm) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4f", norm);
    return std::string(text);
  };
  const Interval& first = plan.pilot.bounces[0].norm;
  const std::string planFirst = shown(first.low) + " to " + shown(first.high),
                    bakeFirst = all.bake.statistics.bounces.empty()
                                    ? "0"
                                    : shown(all.bake.statistics.bounces[0].norm);
  std::printf("| %s | %zu | %s | %.3f | %.3f | %.3f | %.3f | %.0f%% | %.1f%% | %.2f | %s | %s | %.2g |\n",
              path.filename().c_str(), scene.mesh.positions.size(), neededIn(plan).c_str(), planSeconds,
              predicted, planned.seconds, all.seconds,
              100 * (1 - (planned.seconds + planSeconds) / all.seconds), 100 * planSeconds / all.seconds,
              predicted / planned.seconds, planFirst.c_str(), bakeFirst.c_str(),
              difference(scene, planned.bake.transfer, all.bake.transfer));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int rays = argc > 1 ? std::max(1, std::atoi(argv[1])) : 256;
  std::optional<Vec3f> albedo;
  if (argc > 2 && argv[2][0] != '-') {
    const float grey = std::strtof(argv[2], nullptr);
    albedo = Vec3f{grey, grey, grey};
  }
  std::vector<std::filesystem::path> scenes(argv + std::min(argc, 3), argv + argc);
  if (scenes.empty()) scenes = everyScene();
  std::printf(
      "| scene | vertices | called for | plan s | predicted s | planned bake s | everything s | saved | plan "
      "/ "
      "everything | predicted / taken | first bounce: plan | bake | difference "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::filesystem::path& scene : scenes) {
    try {
      measure(scene, rays, albedo);
    } catch (const Error& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
  }
  return 0;
}
