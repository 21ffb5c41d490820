// Evaluating spherical harmonics in batches, beside storing the same number of floats to the same rows, which
// is what a kernel whose arithmetic cost nothing would take. One thread, in cache: 256 directions a call to
// degree 4, 128 to degree 8, 64 beyond. The number in a name is the degree. The first variant is the one that
// is chosen on this processor. Accumulation is the inner loop of baking; `reference` is evaluateSh, one
// direction at a time in double.

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "bench/ratio.h"
#include "bench/store_rows.h"
#include "shprt/sh/accumulate_variants.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/evaluate_batch_variants.h"

namespace {

using namespace shprt;

struct Tile {
  std::size_t count;
  std::vector<float> x, y, z, weights;

  explicit Tile(std::size_t n) : count(n), weights(n, 1.0f) {
    for (std::size_t k = 0; k < n; ++k) {
      const double height = 1 - (2 * static_cast<double>(k) + 1) / static_cast<double>(n);
      const double sine = std::sqrt(1 - height * height),
                   angle = std::numbers::pi * (3 - std::sqrt(5)) * static_cast<double>(k);
      x.push_back(static_cast<float>(sine * std::cos(angle)));
      y.push_back(static_cast<float>(sine * std::sin(angle)));
      z.push_back(static_cast<float>(height));
    }
  }
};

}  // namespace

int main(int argc, char** argv) {
  std::vector<shprt::bench::Ratio> ratios;
  std::vector<float> results(1 << 20);
  // Rows that begin with a cache line, as a caller in a hurry will have them.
  const std::size_t misaligned = reinterpret_cast<std::size_t>(results.data()) / sizeof(float) % 16;
  float* rows = results.data() + (misaligned == 0 ? 0 : 16 - misaligned);
  std::vector<double> allSums(coefficientCount(kMaximumBakeDegree));
  double* sums = allSums.data();
  const auto add = [](const std::string& name, auto body) {
    benchmark::RegisterBenchmark(name.c_str(), [body](benchmark::State& state) {
      for (auto _ : state) {
        body();
        benchmark::ClobberMemory();
      }
    })->Repetitions(9);
  };
  for (const int degree : {2, 3, 4, 6, 8, 14, 20, 32}) {
    const std::string suffix = "_" + std::to_string(degree);
    const Tile tile(degree <= 4 ? 256 : degree <= 8 ? 128 : 64);
    const std::size_t coefficients = static_cast<std::size_t>(coefficientCount(degree));
    add("store" + suffix, [=] { shprt::bench::storeRows(rows, coefficients * tile.count); });
    for (const EvaluateBatchVariant& variant : evaluateBatchVariants()) {
      const std::string name = std::string("evaluate_") + variant.name + suffix;
      add(name, [=] {
        variant.function(degree, tile.x.data(), tile.y.data(), tile.z.data(), tile.count, rows, tile.count);
      });
      if (&variant == &evaluateBatchVariants().front()) ratios.push_back({name, "store" + suffix, 1.6});
    }
    for (const AccumulateVariant& variant : accumulateVariants()) {
      const std::string name = std::string("accumulate_") + variant.name + suffix;
      add(name, [=] {
        variant.function(degree, tile.x.data(), tile.y.data(), tile.z.data(), tile.weights.data(), tile.count,
                         sums);
      });
      if (&variant == &accumulateVariants().front())
        ratios.push_back({name, std::string("evaluate_") + variant.name + suffix, 2.5});
    }
    add("reference" + suffix, [=] {
      for (std::size_t k = 0; k < tile.count; ++k)
        evaluateSh(degree, {tile.x[k], tile.y[k], tile.z[k]}, {sums, coefficients});
    });
  }
  return shprt::bench::runWithRatios(argc, argv, ratios);
}
