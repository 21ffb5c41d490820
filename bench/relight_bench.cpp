// Relighting a million vertices of degree 4 in memory, beside copying the same bytes.

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "bench/ratio.h"
#include "shprt/relight/relight.h"

namespace {

using namespace shprt;

TransferCoefficients makeTransfer(int channels) {
  TransferCoefficients transfer;
  transfer.degree = 4;
  transfer.channels = channels;
  transfer.vertexCount = 1'000'000;
  transfer.values.assign(static_cast<std::size_t>(channels * transfer.rows()) * transfer.vertexCount, 0.25f);
  return transfer;
}

void copyParallel(const std::vector<float>& from, std::vector<float>& to) {
  constexpr std::size_t kBlock = 1 << 16;
  tbb::parallel_for(std::size_t{0}, (from.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
    const std::size_t begin = block * kBlock, count = std::min(kBlock, from.size() - begin);
    std::memcpy(&to[begin], &from[begin], count * sizeof(float));
  });
}

}  // namespace

int main(int argc, char** argv) {
  LightCoefficients light;
  light.degree = 4;
  light.coefficients.assign(25, {1.0, 0.5, 0.25});
  std::vector<shprt::bench::Ratio> ratios;
  std::vector<TransferCoefficients> transfers = {makeTransfer(1), makeTransfer(3)};
  std::vector<float> copy(transfers[1].values.size());
  for (TransferCoefficients& transfer : transfers) {
    const std::string suffix = transfer.channels == 1 ? "_grey" : "_rgb";
    const auto configure = [](benchmark::internal::Benchmark* b) {
      b->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(7);
    };
    configure(benchmark::RegisterBenchmark(("copy" + suffix).c_str(), [&](benchmark::State& state) {
      for (auto _ : state) {
        copyParallel(transfer.values, copy);
        benchmark::ClobberMemory();
      }
    }));
    configure(benchmark::RegisterBenchmark(("relight" + suffix).c_str(), [&](benchmark::State& state) {
      for (auto _ : state) benchmark::DoNotOptimize(relight(transfer, light));
    }));
    ratios.push_back({"relight" + suffix, "copy" + suffix, 2.0});
  }
  return shprt::bench::runWithRatios(argc, argv, ratios);
}
