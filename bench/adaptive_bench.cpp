// Bakes that are asked for an error: what they reach, and what it costs beside the same rays everywhere.
// Prints two Markdown tables. The reference is a bake of 65,536 lattice rays (or REFERENCE_RAYS) per vertex
// with another seed; errors are the RMS of docs/accuracy.md.
//
// Usage: bench_adaptive [REFERENCE_RAYS]; shared meshes that are missing are left out.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include "shprt/scene/load_scene.h"
#include "shprt/transfer/planned_bake.h"
#include "shprt/transfer/stopwatch.h"
#include "tests/transfer/test_meshes.h"

namespace {

using namespace shprt;

constexpr int kDegree = 4;

double rms(const TransferCoefficients& a, const TransferCoefficients* b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double difference = static_cast<double>(a.values[i]) - (b ? static_cast<double>(b->values[i]) : 0);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

// A wide field of 201 x 201 vertices with four balls in its middle. All of it looks up at them, and little of
// it is in their shadow.
Scene makeField() {
  Mesh mesh;
  test::addPatch(mesh, {-300, 0, -300}, {0, 0, 600}, {600, 0, 0}, 200);
  for (const double x : {-0.75, 0.75})
    for (const double z : {-0.75, 0.75})
      test::append(mesh, test::moved(test::makeIcosphere(3), 0.7, {x, 0.9, z}));
  return test::grey(mesh, 0.8f);
}

// A village of 36 houses amid gently rolling hills of 301 x 301 vertices: the hills see nearly all of the sky
// there is, and deep shadows lie only between the houses.
Scene makeVillage() {
  constexpr int kCells = 300;
  constexpr double kHalf = 600, kHeight = 0, kWave = 90;
  const auto ground = [](double x, double z) {
    const double fade = std::clamp((std::hypot(x, z) - 40) / 100, 0.0, 1.0);  // level under the houses
    return fade * kHeight * std::sin(x / kWave) * std::cos(z / kWave);
  };
  Mesh mesh;
  test::addPatch(mesh, {-kHalf, 0, -kHalf}, {0, 0, 2 * kHalf}, {2 * kHalf, 0, 0}, kCells);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double x = static_cast<double>(mesh.positions[i].x), z = static_cast<double>(mesh.positions[i].z);
    constexpr double kStep = 1e-3;
    mesh.positions[i].y = static_cast<float>(ground(x, z));
    mesh.normals[i] = toFloat(normalize(Vec3d{ground(x - kStep, z) - ground(x + kStep, z), 2 * kStep,
                                              ground(x, z - kStep) - ground(x, z + kStep)}));
  }
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      test::append(mesh, test::makeBox({-23.0 + 8 * i, 0, -23.0 + 8 * j}, {5, 4, 5}, 4));
  return test::grey(mesh, 0.8f);
}

struct Case {
  std::string name;
  Scene scene;
  std::string model;
};

struct Timed {
  Bake bake;
  double seconds;
};

Timed bakeTimed(const PreparedScene& prepared, const BakeRequest& request) {
  const Stopwatch watch;
  Bake bake = bakeRequested(prepared, request);
  return {std::move(bake), watch.seconds()};
}

void compare(const Case& what, int referenceRays) {
  const PreparedScene prepared(what.scene);
  const BakeRequest request{.model = what.model, .degree = kDegree, .bounces = {}, .error = 1e-4};
  BakeRequest referenceRequest = request;
  referenceRequest.rays = referenceRays, referenceRequest.seed = 999;
  const TransferCoefficients reference = bakeRequested(prepared, referenceRequest).transfer;
  const double scale = rms(bakeUnshadowed(what.scene, kDegree).transfer, nullptr);

  std::vector<std::pair<double, double>> fixed;  // error, seconds
  for (int rays = 16; rays <= referenceRays / 8; rays *= 2) {
    BakeRequest fixedRequest = request;
    fixedRequest.rays = rays;
    const Timed timed = bakeTimed(prepared, fixedRequest);
    fixed.emplace_back(rms(timed.bake.transfer, &reference) / scale, timed.seconds);
  }
  const auto secondsOfFixed = [&](double error) {  // on straight lines in log-log
    std::size_t next = 1;
    while (next + 1 < fixed.size() && fixed[next].first > error) ++next;
    const auto [e0, s0] = fixed[next - 1];
    const auto [e1, s1] = fixed[next];
    return s0 * std::pow(s1 / s0, std::log(error / e0) / std::log(e1 / e0));
  };

  if (std::getenv("FIXED"))
    for (std::size_t i = 0; i < fixed.size(); ++i)
      std::printf("%d %.5f %.3f\n", 16 << i, fixed[i].first, fixed[i].second);
  for (const double asked : {0.1, 0.03, 0.01, 0.003, 0.001}) {
    BakeRequest adaptive = request;
    adaptive.samplingError = asked;
    const Timed timed = bakeTimed(prepared, adaptive);
    const SamplingStatistics& sampling = timed.bake.statistics.sampling;
    const double error = rms(timed.bake.transfer, &reference) / scale;
    double rays = 0, vertices = 0;
    for (const auto& [count, number] : sampling.verticesByRays)
      rays += static_cast<double>(count) * static_cast<double>(number),
          vertices += static_cast<double>(number);
    const double same = secondsOfFixed(error);
    std::printf("| %s | %.3g | %.4f | %.4f | %.4f | %.2f | %.2f | %zu | %.0f | %.2f | %.2f | %.1f |\n",
                what.name.c_str(), asked, sampling.error, sampling.errorBound, error, error / asked,
                sampling.error / error, sampling.passes.size(), rays / vertices, timed.seconds, same,
                same / timed.seconds);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int referenceRays = argc > 1 ? std::atoi(argv[1]) : 65536;
  const std::string only = argc > 2 ? argv[2] : "";
  std::vector<Case> cases;
  const auto add = [&](const std::string& name, auto make, const char* model) {
    if (only.empty() || name.find(only) != std::string::npos) cases.push_back({name, make(), model});
  };
  add("field", makeField, "shadowed");
  add("village", makeVillage, "shadowed");
  for (const auto& [name, file, model] :
       {std::tuple("knot", SHPRT_SOURCE_DIR "/data/knot.ply", "shadowed"),
        std::tuple("courtyard", SHPRT_SOURCE_DIR "/data/courtyard.obj", "interreflected"),
        std::tuple("cornell", SHPRT_SOURCE_DIR "/data/cornell.json", "interreflected"),
        std::tuple("suzanne", SHPRT_SHARED_DIR "/data/meshes/suzanne.obj", "interreflected"),
        std::tuple("fandisk", SHPRT_SHARED_DIR "/data/meshes/fandisk.obj", "shadowed"),
        std::tuple("cornell_box", SHPRT_SHARED_DIR "/data/meshes/cornell_box.obj", "interreflected"),
        std::tuple("bunny", SHPRT_SHARED_DIR "/data/meshes/stanford-bunny.obj", "shadowed")})
    if (std::filesystem::exists(file))
      add(
          name, [&] { return loadScene(file, {}); }, model);
  std::printf(
      "Degree %d, reference %d rays.\n\n| scene | asked | estimated | bound | true | true/asked | "
      "estimated/true | passes | rays per vertex | s | s with the same rays everywhere | ratio |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n",
      kDegree, referenceRays);
  for (const Case& what : cases) compare(what, referenceRays);
}
