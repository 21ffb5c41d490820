// Projecting a 1024 x 512 latitude-longitude probe: separable sums, beside a plain loop that evaluates the
// basis at every pixel. One thread.

#include <cmath>
#include <vector>

#include "bench/ratio.h"
#include "shprt/base/parallel.h"
#include "shprt/light/project_probe.h"
#include "shprt/sh/basis.h"

namespace {

using namespace shprt;

EnvironmentMap makeMap() {
  EnvironmentMap map;
  map.image = {1024, 512, std::vector<Vec3f>(1024 * 512)};
  for (std::size_t i = 0; i < map.image.pixels.size(); ++i) {
    const auto f = static_cast<float>(i);
    map.image.pixels[i] = {1 + std::sin(f), 2 + std::cos(0.7f * f), 0.5f};
  }
  return map;
}

double projectPlainly(const EnvironmentMap& map, int degree) {
  std::vector<double> basis(static_cast<std::size_t>(coefficientCount(degree))), sums(3 * basis.size());
  for (int y = 0; y < map.image.height; ++y)
    for (int x = 0; x < map.image.width; ++x) {
      const PixelFootprint footprint = pixelFootprint(map.layout, map.image.width, map.image.height, x, y);
      evaluateSh(degree, footprint.direction, basis);
      const Vec3f& pixel = map.image.at(x, y);
      const double radiance[3] = {static_cast<double>(pixel.x), static_cast<double>(pixel.y),
                                  static_cast<double>(pixel.z)};
      for (std::size_t i = 0; i < basis.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) sums[3 * i + c] += footprint.solidAngle * basis[i] * radiance[c];
    }
  return sums[0];
}

}  // namespace

int main(int argc, char** argv) {
  setThreadCount(1);
  const EnvironmentMap map = makeMap();
  std::vector<shprt::bench::Ratio> ratios;
  for (const int degree : {4, 8}) {
    const std::string suffix = "_degree_" + std::to_string(degree);
    const auto configure = [](benchmark::internal::Benchmark* b) {
      b->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Repetitions(5);
    };
    configure(
        benchmark::RegisterBenchmark(("separable" + suffix).c_str(), [&, degree](benchmark::State& state) {
          for (auto _ : state) benchmark::DoNotOptimize(projectProbe(map, {.degree = degree}));
        }));
    configure(benchmark::RegisterBenchmark(("plain" + suffix).c_str(), [&, degree](benchmark::State& state) {
      for (auto _ : state) benchmark::DoNotOptimize(projectPlainly(map, degree));
    }));
    ratios.push_back({"separable" + suffix, "plain" + suffix, 0.1});
  }
  return shprt::bench::runWithRatios(argc, argv, ratios);
}
