// How near interpolated vertex transfer comes to what every pixel would see: baked at the vertices, and
// fitted to samples over the triangles, on low-poly scenes. Prints four tables in Markdown: errors over
// sample counts at the default regulariser, errors over regularisers at the default count, what the defaults
// cost; and the same for light that bounces (bounced_comparison.h).
//
// The truth is shadowed transfer at dense samples of another seed, with many rays. An error is the RMS over
// area of the 2-norm of what interpolation misses it by, over that of the unshadowed transfer, in percent.
//
// Usage: bench_fit [RAYS [TRUTH_RAYS]]; scenes whose file is missing are left out.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bench/bounced_comparison.h"
#include "shprt/mesh/load_mesh.h"
#include "shprt/scene/load_scene.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/fitted.h"
#include "shprt/transfer/sample_transfer.h"
#include "shprt/transfer/transfer_rows.h"
#include "tests/transfer/test_meshes.h"

namespace {

using namespace shprt;

constexpr int kDegree = 4;
constexpr std::array kBouncedCounts = {8.0, 32.0};

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

std::vector<NamedMesh> lowPolyMeshes() {
  std::vector<NamedMesh> meshes;
  Mesh box = test::makeBox({-0.3, 0.2, -0.3}, {0.6, 0.4, 0.6}, 1);
  test::addPatch(box, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0}, 4);
  meshes.push_back({"box over a 4x4 floor", box});
  Mesh wall;
  test::addPatch(wall, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0}, 5);
  test::append(wall, test::makeBox({-0.1, 0, -1}, {0.2, 1, 2}, 1));
  meshes.push_back({"wall on a 5x5 floor", wall});
  for (const auto& [name, file] :
       {std::pair("teapot", SHPRT_SHARED_DIR "/data/meshes/teapot.obj"),
        std::pair("suzanne", SHPRT_SHARED_DIR "/data/meshes/suzanne.obj"),
        std::pair("cornell_box", SHPRT_SHARED_DIR "/data/meshes/cornell_box.obj"),
        std::pair("sphere_plane", SHPRT_SHARED_DIR "/data/meshes/sphere_plane.obj"),
        std::pair("fandisk", SHPRT_SHARED_DIR "/data/meshes/fandisk.obj"),
        std::pair("courtyard", SHPRT_SOURCE_DIR "/data/courtyard.obj")})
    if (std::filesystem::exists(file)) meshes.push_back({name, loadMesh(file).mesh});
  return meshes;
}

class Comparison {
 public:
  Comparison(const NamedMesh& named, int rays, int truthRays)
      : scene_(test::grey(named.mesh, 1)),
        prepared_(scene_),
        shadowed_{.degree = kDegree, .rays = rays, .seed = 1},
        start_(bakeShadowed(prepared_, shadowed_).transfer.values),
        truthSamples_(sampleSurface(scene_, prepared_.topology, denseSampling())) {
    truth_ = measure(truthSamples_, {.degree = kDegree, .rays = truthRays, .seed = 1001});
    std::vector<double> unshadowed(truth_.rows);
    UnshadowedTransfer(kDegree).evaluate({0, 0, 1}, unshadowed);
    double squares = 0;
    for (const double c : unshadowed) squares += c * c;
    unit_ = std::sqrt(squares) / 100;
  }

  double atVertices() const { return errorOf(start_); }

  // What a default bake costs: time per ray of a sample over that of a vertex, the fit's share of the
  // samples' time, iterations, samples per vertex, the least and greatest visible share that the fit gives a
  // vertex.
  std::vector<double> costs() const {
    const FittedBake fitted = bakeFitted(prepared_, shadowed_, {});
    const double vertices = static_cast<double>(fitted.bake.statistics.samplePoints - fitted.samples);
    const double samples = static_cast<double>(fitted.samples);
    const double vertexSeconds = fitted.bake.statistics.traceSeconds - fitted.sampleSeconds;
    const float* shares = fitted.bake.transfer.row(0, 0);
    const auto [least, greatest] = std::minmax_element(shares, shares + scene_.mesh.positions.size());
    const double unshadowed = 1 / std::sqrt(4 * std::numbers::pi);
    return {(fitted.sampleSeconds / samples) / (vertexSeconds / vertices),
            fitted.fitSeconds / fitted.sampleSeconds,
            static_cast<double>(fitted.fit.iterations),
            samples / vertices,
            static_cast<double>(*least) / unshadowed,
            static_cast<double>(*greatest) / unshadowed,
            errorOf(fitted.bake.transfer.values)};
  }

  // Samples once per count; then one error for each alpha.
  std::vector<double> fitted(double perTriangle, const std::vector<double>& alphas) const {
    auto samples =
        sampleSurface(scene_, prepared_.topology, {.perTriangle = perTriangle, .minimum = 4, .seed = 1});
    const SampleValues values = measure(samples, shadowed_);
    std::vector<double> errors;
    for (const double alpha : alphas) {
      FitOptions options;
      options.alpha = alpha;
      errors.push_back(errorOf(fitToSamples(prepared_.topology, samples, values, start_, options).values));
    }
    return errors;
  }

 private:
  // Without the samples that nobody sees.
  SampleValues measure(std::vector<SurfaceSample>& samples, const ShadowedOptions& options) const {
    SampleTransfer transfer = bakeSamples(prepared_, samples, options);
    removeSamples(transfer.buried, samples, transfer.transfer);
    return std::move(transfer.transfer);
  }

  // About 40,000 samples, at least 8 per triangle.
  SampleOptions denseSampling() const {
    const double triangles = static_cast<double>(scene_.mesh.triangles.size());
    return {.perTriangle = std::max(8.0, 40000 / triangles), .minimum = 8, .seed = 1000};
  }

  double errorOf(const std::vector<float>& vertexValues) const {
    const std::size_t vertexCount = scene_.mesh.positions.size();
    double squares = 0, area = 0;
    for (std::size_t s = 0; s < truthSamples_.size(); ++s) {
      const SurfaceSample& sample = truthSamples_[s];
      const auto& [a, b, c] = scene_.mesh.triangles[sample.triangle];
      area += sample.weight;
      for (std::size_t row = 0; row < truth_.rows; ++row) {
        const float* column = vertexValues.data() + row * vertexCount;
        const auto error = static_cast<double>(column[a] * (1 - sample.u - sample.v) + column[b] * sample.u +
                                               column[c] * sample.v - truth_.at(s)[row]);
        squares += sample.weight * error * error;
      }
    }
    return std::sqrt(squares / area) / unit_;
  }

  Scene scene_;
  PreparedScene prepared_;
  ShadowedOptions shadowed_;
  std::vector<float> start_;
  std::vector<SurfaceSample> truthSamples_;
  SampleValues truth_;
  double unit_ = 1;
};

// Errors of light that bounces in a scene: at vertices, and fitted at some sample counts; and how much longer
// the default fit takes.
std::string bouncedRow(const std::string& name, const Scene& scene, double maxEdge, int rays, int truthRays) {
  const bench::BouncedComparison comparison(scene, maxEdge, kDegree, truthRays);
  const PreparedScene prepared(scene);
  const InterreflectedOptions options{.degree = kDegree, .rays = rays, .seed = 1, .error = 0.003};
  const auto seconds = [](const BakeStatistics& s) { return s.traceSeconds + s.bounceSeconds; };
  const Bake vertices = bakeInterreflected(prepared, options);
  std::vector<bench::BouncedError> errors = {comparison.errorOf(vertices)};
  double ratio = 0;
  for (const double count : kBouncedCounts) {
    const FittedBake fitted =
        bakeFittedInterreflected(prepared, options, {.samples = {.perTriangle = count}});
    errors.push_back(comparison.errorOf(fitted.bake));
    if (count == SampleOptions{}.perTriangle)
      ratio = (seconds(fitted.bake.statistics) + fitted.fitSeconds) / seconds(vertices.statistics);
  }
  std::string row = "| " + name + " |";
  char number[32];
  const auto add = [&](double figure) {
    std::snprintf(number, sizeof number, " %.2f |", figure);
    row += number;
  };
  for (const bench::BouncedError& error : errors) add(error.transfer);
  for (const bench::BouncedError& error : errors) add(error.emission);
  add(ratio);
  std::fprintf(stderr, "%s: %zu vertices, truth on %zu\n", name.c_str(), scene.mesh.positions.size(),
               comparison.vertices());
  return row;
}

// Scenes that light bounces in, with the longest edge that their truth may have.
std::vector<std::string> bouncedRows(int rays, int truthRays) {
  std::vector<std::string> rows;
  const auto add = [&](const std::string& name, const std::string& file, double maxEdge, Vec3f lamp) {
    if (!std::filesystem::exists(file)) return;
    Scene scene = loadScene(file);
    for (SurfaceMaterial& material : scene.materials)
      if (material.name == "light") material.emission = lamp;
    rows.push_back(bouncedRow(name, scene, maxEdge, rays, truthRays));
  };
  add("cornell_box", SHPRT_SHARED_DIR "/data/meshes/cornell_box.obj", 16, {20, 20, 20});
  add("cornell", SHPRT_SOURCE_DIR "/data/cornell.json", 0.06, {});
  add("courtyard", SHPRT_SOURCE_DIR "/data/courtyard.obj", 0.08, {});
  return rows;
}

void printHeader(const std::string& first, const std::vector<std::string>& columns) {
  std::printf("\n| %s |", first.c_str());
  for (const std::string& column : columns) std::printf(" %s |", column.c_str());
  std::printf("\n|---|");
  for (std::size_t i = 0; i < columns.size(); ++i) std::printf("---|");
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const int rays = argc > 1 ? std::max(1, std::atoi(argv[1])) : 256;
  const int truthRays = argc > 2 ? std::max(1, std::atoi(argv[2])) : 1024;
  const std::vector<double> counts = {1, 4, 8, 16, 32, 64};
  const std::vector<double> alphas = {0, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1};
  const double defaultCount = SampleOptions{}.perTriangle, defaultAlpha = FitOptions{}.alpha;

  std::vector<std::string> byCount, byAlpha, costs;
  for (const NamedMesh& named : lowPolyMeshes()) {
    const Comparison comparison(named, rays, truthRays);
    const auto row = [&](const std::vector<double>& errors) {
      std::string text = "| " + named.name + " |";
      char number[32];
      for (const double error : errors) {
        std::snprintf(number, sizeof number, " %.2f |", error);
        text += number;
      }
      return text;
    };
    std::vector<double> errors = {comparison.atVertices()};
    for (const double count : counts) errors.push_back(comparison.fitted(count, {defaultAlpha})[0]);
    byCount.push_back(row(errors));
    byAlpha.push_back(row(comparison.fitted(defaultCount, alphas)));
    costs.push_back(row(comparison.costs()));
    std::fprintf(stderr, "%s: %zu vertices, %zu triangles\n", named.name.c_str(), named.mesh.positions.size(),
                 named.mesh.triangles.size());
  }

  std::printf("Error in percent of the unshadowed transfer, degree %d, %d rays; alpha %g\n", kDegree, rays,
              defaultAlpha);
  std::vector<std::string> columns = {"at vertices"};
  char number[64];
  for (const double count : counts) {
    std::snprintf(number, sizeof number, "fit, %g per triangle", count);
    columns.emplace_back(number);
  }
  printHeader("scene", columns);
  for (const std::string& row : byCount) std::printf("%s\n", row.c_str());

  std::printf("\nThe same over alpha, %g samples per triangle\n", defaultCount);
  columns.clear();
  for (const double alpha : alphas) {
    std::snprintf(number, sizeof number, "alpha %g", alpha);
    columns.emplace_back(number);
  }
  printHeader("scene", columns);
  for (const std::string& row : byAlpha) std::printf("%s\n", row.c_str());

  std::printf("\nCosts of the defaults\n");
  printHeader("scene", {"seconds per ray, sample / vertex", "seconds, fit / samples", "iterations",
                        "samples per vertex", "least visible share", "greatest", "error"});
  for (const std::string& row : costs) std::printf("%s\n", row.c_str());

  std::printf(
      "\nLight that bounces: errors of transfer in percent of the unshadowed, of emission in percent of "
      "itself\n");
  columns.clear();
  for (const std::string quantity : {"transfer", "emission"}) {
    columns.push_back(quantity + ", at vertices");
    for (const double count : kBouncedCounts) {
      std::snprintf(number, sizeof number, "fit, %g per triangle", count);
      columns.emplace_back(number);
    }
  }
  columns.emplace_back("seconds, default fit / vertices");
  printHeader("scene", columns);
  for (const std::string& row : bouncedRows(rays, truthRays)) std::printf("%s\n", row.c_str());
  return 0;
}
