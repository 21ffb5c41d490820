// Rotating one coefficient set, building the rotation from a matrix included, beside the dense product of
// Wigner matrices that are there already; and many sets by one rotation, beside a copy. One thread.

#include <cstring>
#include <string>
#include <vector>

#include "bench/ratio.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"

namespace {

using namespace shprt;

#if defined(__x86_64__) && !defined(__clang__)
#define SHPRT_BENCH_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define SHPRT_BENCH_CLONES
#endif

// Matrices of all bands, each in columns one after another.
std::vector<double> denseMatrices(int degree, const Mat3& rotation) {
  std::vector<double> columns;
  for (int l = 0; l <= degree; ++l) {
    const std::vector<double> rows = wignerMatrix(l, transpose(rotation));
    columns.insert(columns.end(), rows.begin(), rows.end());
  }
  return columns;
}

// The product as one writes it for the compiler to vectorise: four columns at a time onto the result.
SHPRT_BENCH_CLONES
void multiplyBands(int degree, const double* __restrict columns, const double* __restrict from,
                   double* __restrict to) {
  for (int l = 0; l <= degree; ++l) {
    const int size = 2 * l + 1;
    for (int m = 0; m < size; ++m) to[m] = columns[m] * from[0];
    int n = 1;
    for (; n + 4 <= size; n += 4) {
      const double *a = columns + n * size, *b = a + size, *c = b + size, *d = c + size;
      for (int m = 0; m < size; ++m)
        to[m] += (a[m] * from[n] + b[m] * from[n + 1]) + (c[m] * from[n + 2] + d[m] * from[n + 3]);
    }
    for (; n < size; ++n)
      for (int m = 0; m < size; ++m) to[m] += columns[n * size + m] * from[n];
    columns += size * size;
    from += size;
    to += size;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Mat3 rotation = parseRotation("euler:zyz,20,35,-70");
  std::vector<shprt::bench::Ratio> ratios;
  const auto configure = [](benchmark::internal::Benchmark* b) {
    b->UseRealTime()->MinTime(0.002)->Repetitions(50);
  };
  for (const int degree : {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24, 28, 32}) {
    const auto count = static_cast<std::size_t>(coefficientCount(degree));
    const std::string suffix = "_degree_" + std::to_string(degree);
    configure(benchmark::RegisterBenchmark(
        ("dense" + suffix).c_str(), [=, columns = denseMatrices(degree, rotation)](benchmark::State& state) {
          std::vector<double> from(count, 0.25), to(count);
          for (auto _ : state) {
            multiplyBands(degree, columns.data(), from.data(), to.data());
            benchmark::DoNotOptimize(to.data());
            benchmark::ClobberMemory();
          }
        }));
    configure(benchmark::RegisterBenchmark(("rotate" + suffix).c_str(), [=](benchmark::State& state) {
      // Sets take turns: each rotation is of a set that waits for no other rotation.
      std::vector<std::vector<double>> sets(4, std::vector<double>(count, 0.25));
      Mat3 matrix = rotation;
      std::size_t next = 0;
      for (auto _ : state) {
        benchmark::DoNotOptimize(&matrix);
        benchmark::ClobberMemory();
        ShRotation(degree, matrix).apply(sets[next]);
        next = (next + 1) % 4;
      }
    }));
    ratios.push_back({"rotate" + suffix, "dense" + suffix, degree <= 5 ? 1.0 : 1.5});
  }
  constexpr std::size_t kSets = 1'000'000;
  std::vector<float> from, to;
  for (const int degree : {1, 2, 3, 4, 6, 8}) {
    const std::string suffix = "_degree_" + std::to_string(degree);
    const std::size_t floats = kSets * static_cast<std::size_t>(coefficientCount(degree));
    const auto fill = [&from, &to, floats] {
      from.assign(floats, 0.25f);
      to.assign(floats, 0);
    };
    const auto few = [&](benchmark::internal::Benchmark* b) {
      b->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1)->Repetitions(15);
    };
    few(benchmark::RegisterBenchmark(("copy" + suffix).c_str(), [=, &from, &to](benchmark::State& state) {
      if (from.size() != floats) fill();
      for (auto _ : state) {
        std::memcpy(to.data(), from.data(), floats * sizeof(float));
        benchmark::ClobberMemory();
      }
    }));
    few(benchmark::RegisterBenchmark(
        ("rotate_many" + suffix).c_str(), [=, &from, &to](benchmark::State& state) {
          if (from.size() != floats) fill();
          for (auto _ : state) {
            rotateMany(ShRotation(degree, rotation), from.data(), to.data(), kSets, kSets);
            benchmark::ClobberMemory();
          }
        }));
    ratios.push_back({"rotate_many" + suffix, "copy" + suffix, degree <= 4 ? 1.2 : 4});
  }
  return shprt::bench::runWithRatios(argc, argv, ratios);
}
