// RMS error of shadowed transfer against rays per vertex for every set of directions, with and without the
// control variate, and how many rays others need for the error of the lattice at 256. Error is the RMS over
// vertices of the coefficient error's 2-norm, over the RMS of the unshadowed transfer's norm; the reference
// is a bake of 65,536 rays with another seed. Prints Markdown; times nothing.
// Usage: bench_sampling_error [MESH] [DEGREE] [REFERENCE_RAYS]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "shprt/mesh/load_mesh.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/prepared_scene.h"

namespace {

using namespace shprt;

struct Method {
  const char* name;
  PointSet points;
  bool controlVariate;
};

constexpr Method kMethods[] = {{"plain random", PointSet::kRandom, false},
                               {"random", PointSet::kRandom, true},
                               {"plain jittered", PointSet::kJittered, false},
                               {"jittered", PointSet::kJittered, true},
                               {"Sobol", PointSet::kSobol, true},
                               {"lattice", PointSet::kLattice, true}};
constexpr int kRays[] = {16, 64, 256, 1024, 4096};
constexpr std::size_t kAsked = 2;  // 256 rays

// The 2-norm over all vertices of a - b, or of a alone.
double norm(const TransferCoefficients& a, const TransferCoefficients* b = nullptr) {
  double sum = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double difference = static_cast<double>(a.values[i]) - (b ? static_cast<double>(b->values[i]) : 0);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

// Where the line through the measurements in log-log coordinates, prolonged at its ends, meets `error`.
double raysFor(const std::vector<double>& errors, double error) {
  std::size_t next = 1;
  while (next + 1 < errors.size() && errors[next] > error) ++next;
  const double slope = std::log(errors[next] / errors[next - 1]) /
                       std::log(static_cast<double>(kRays[next]) / kRays[next - 1]);
  return kRays[next] * std::pow(error / errors[next], 1 / slope);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : SHPRT_SOURCE_DIR "/data/knot.ply";
  const int degree = argc > 2 ? std::atoi(argv[2]) : 4;
  const int referenceRays = argc > 3 ? std::atoi(argv[3]) : 65536;
  const Mesh mesh = loadMesh(path).mesh;
  const Scene scene = makeScene(mesh, std::vector<Vec3f>(mesh.positions.size(), Vec3f{1, 1, 1}));
  const PreparedScene prepared(scene);
  const TransferCoefficients reference =
      bakeShadowed(prepared, {.degree = degree, .rays = referenceRays, .seed = 999}).transfer;
  const double scale = norm(bakeUnshadowed(scene, degree).transfer);
  std::printf(
      "%s, %zu vertices, degree %d, reference %d rays; plain: without the control variate\n\n| rays |",
      path.c_str(), mesh.positions.size(), degree, referenceRays);
  for (const Method& method : kMethods) std::printf(" %s |", method.name);
  std::printf("\n|---|");
  for (std::size_t i = 0; i < std::size(kMethods); ++i) std::printf("---|");
  std::vector<double> errors[std::size(kMethods)];
  for (const int rays : kRays) {
    std::printf("\n| %d |", rays);
    for (std::size_t i = 0; i < std::size(kMethods); ++i) {
      // Points that need no rays are exact by the control variate only.
      const ShadowedOptions options{.degree = degree,
                                    .rays = rays,
                                    .seed = 1,
                                    .traceEverything = !kMethods[i].controlVariate,
                                    .points = kMethods[i].points,
                                    .controlVariate = kMethods[i].controlVariate};
      errors[i].push_back(norm(bakeShadowed(prepared, options).transfer, &reference) / scale);
      std::printf(" %.3g |", errors[i].back());
      std::fflush(stdout);
    }
  }
  const double asked = errors[std::size(kMethods) - 1][kAsked];
  std::printf("\n\nFor the error of %d lattice rays, %.3g:\n", kRays[kAsked], asked);
  for (std::size_t i = 0; i + 1 < std::size(kMethods); ++i) {
    const double rays = raysFor(errors[i], asked);
    std::printf("- %s: %.0f rays, %.2f times as many\n", kMethods[i].name, rays, rays / kRays[kAsked]);
  }
}
