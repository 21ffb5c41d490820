// Products by the triple-product tensor beside reading the tensor once, single products beside those, and
// rotation by zonal lobes beside two dense products with a matrix per band, which is what the lobes do
// besides evaluating the basis at each of them (the greater part of their time).

#include <cstddef>
#include <string>
#include <vector>

#include "bench/ratio.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/product.h"
#include "shprt/sh/zonal_lobes.h"

namespace {

using namespace shprt;

std::vector<double> coefficients(int degree) {
  std::vector<double> values;
  for (int i = 0; i < coefficientCount(degree); ++i) values.push_back(1.0 / (i + 1));
  return values;
}

void registerFastest(const std::string& name, const auto& body) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [work = body](benchmark::State& state) mutable {
                                 for (auto _ : state) work();
                               })
      ->Repetitions(7)
      ->MinTime(0.05);
}

void registerProducts(int degree, std::vector<bench::Ratio>& ratios) {
  const std::string suffix = "_" + std::to_string(degree);
  const TripleProductTensor tensor(degree, degree, degree);
  registerFastest("read" + suffix, [tensor] {
    double sum = 0;
    int indices = 0;
    for (const TripleProduct& t : tensor.entries()) {
      sum += t.value;
      indices ^= t.i ^ t.j ^ t.k;
    }
    benchmark::DoNotOptimize(sum);
    benchmark::DoNotOptimize(indices);
  });
  const std::vector<double> f = coefficients(degree);
  registerFastest("multiply" + suffix, [tensor, f, product = f]() mutable {
    tensor.multiply(f, f, product);
    benchmark::ClobberMemory();
  });
  registerFastest("build" + suffix, [degree] { TripleProductTensor(degree, degree, degree); });
  registerFastest("direct" + suffix,
                  [degree, f] { benchmark::DoNotOptimize(productCoefficients(f, f, degree)); });
  ratios.push_back({"multiply" + suffix, "read" + suffix, 3.0});
  ratios.push_back({"build" + suffix, "multiply" + suffix, 100.0});
  if (degree >= 8) ratios.push_back({"direct" + suffix, "multiply" + suffix, 1.5});
}

void registerLobes(int degree, std::vector<bench::Ratio>& ratios) {
  const std::string suffix = "_" + std::to_string(degree);
  const ZonalLobes lobes(degree);
  const std::vector<double> f = coefficients(degree);
  registerFastest("two_band_products" + suffix, [lobes, f, once = f, twice = f]() mutable {
    lobes.weights(f, once);
    lobes.weights(once, twice);
    benchmark::ClobberMemory();
  });
  const Mat3 turn{{{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}}};
  registerFastest("rotate_lobes" + suffix, [lobes, turn, rotated = f]() mutable {
    lobes.rotate(turn, rotated);
    benchmark::ClobberMemory();
  });
  ratios.push_back({"rotate_lobes" + suffix, "two_band_products" + suffix, 12.0});
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<shprt::bench::Ratio> ratios;
  for (const int degree : {2, 4, 8}) registerProducts(degree, ratios);
  for (const int degree : {2, 4, 8, 16}) registerLobes(degree, ratios);
  return shprt::bench::runWithRatios(argc, argv, ratios);
}
