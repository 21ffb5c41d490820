// Writing and reading assets of degree 4, RGB, with every compression, in float and half: seconds and bytes
// per vertex. The values are a bake's: smooth over neighbouring vertices, noisy in their last bits.

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "shprt/coefficients/asset_file.h"
#include "shprt/sampling/random.h"

namespace {

using namespace shprt;

TransferAsset makeAsset(std::size_t vertices) {
  TransferAsset asset;
  asset.transfer.degree = 4;
  asset.transfer.channels = 3;
  asset.transfer.vertexCount = vertices;
  asset.transfer.values.resize(75 * vertices);
  for (std::size_t i = 0; i < asset.transfer.values.size(); ++i) {
    const double smooth =
        std::sin(1e-3 * static_cast<double>(i % vertices) + static_cast<double>(i / vertices));
    asset.transfer.values[i] = static_cast<float>(0.2 * smooth + 0.005 * (uniformRandom(1, i, 0) - 0.5));
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto f = static_cast<float>(v);
    asset.positions.push_back({std::sin(f), std::cos(f), f});
    asset.normals.push_back({0, 1, 0});
    asset.albedo.push_back({0.5f, 0.4f, 0.3f});
  }
  for (std::uint32_t t = 0; t + 2 < vertices; ++t) {
    asset.triangles.push_back({t, t + 1, t + 2});
    asset.triangles.push_back({t, t + 2, t + 1});
  }
  return asset;
}

const TransferAsset& cachedAsset(std::size_t vertices) {
  static TransferAsset asset;
  if (asset.transfer.vertexCount != vertices) asset = makeAsset(vertices);
  return asset;
}

const std::string kFile = (std::filesystem::temp_directory_path() / "shprt_asset_bench.prt.exr").string();

WriteAssetOptions optionsOf(const benchmark::State& state) {
  return {state.range(1) != 0, static_cast<AssetCompression>(state.range(2))};
}

void label(benchmark::State& state) {
  const char* names[] = {"none", "zip", "zips", "piz"};
  state.SetLabel(std::string(state.range(1) ? "half " : "float ") + names[state.range(2)]);
  state.counters["bytes/vertex"] =
      static_cast<double>(std::filesystem::file_size(kFile)) / static_cast<double>(state.range(0));
}

void writeBench(benchmark::State& state) {
  const TransferAsset& asset = cachedAsset(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) writeAsset(kFile, asset, optionsOf(state));
  label(state);
}

void readBench(benchmark::State& state) {
  writeAsset(kFile, cachedAsset(static_cast<std::size_t>(state.range(0))), optionsOf(state));
  for (auto _ : state) benchmark::DoNotOptimize(readAsset(kFile));
  label(state);
}

void everyChoice(benchmark::internal::Benchmark* b) {
  for (const int vertices : {200'000, 1'000'000})
    for (const int half : {0, 1})
      for (int compression = 0; compression < 4; ++compression) b->Args({vertices, half, compression});
  b->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(2);
}

BENCHMARK(writeBench)->Apply(everyChoice);
BENCHMARK(readBench)->Apply(everyChoice);

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  std::filesystem::remove(kFile);
}
