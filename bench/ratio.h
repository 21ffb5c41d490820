// Runs Google Benchmark and prints ratios of the fastest repetitions: on a shared machine the minimum is what
// the code costs, and only a ratio taken in one run travels to another machine.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace shprt::bench {

struct Ratio {
  std::string numerator, denominator;  // benchmark names
  double bound;                        // what the project promises
};

class MinimumReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.iterations <= 0) continue;
      const double seconds = run.real_accumulated_time / static_cast<double>(run.iterations);
      const auto [it, fresh] = fastest_.try_emplace(run.run_name.function_name, seconds);
      if (!fresh) it->second = std::min(it->second, seconds);
    }
    ConsoleReporter::ReportRuns(runs);
  }
  const std::map<std::string, double>& fastest() const { return fastest_; }

 private:
  std::map<std::string, double> fastest_;
};

// Runs what is registered, then prints each ratio of minima beside its bound.
inline int runWithRatios(int argc, char** argv, const std::vector<Ratio>& ratios) {
  benchmark::Initialize(&argc, argv);
  MinimumReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  std::printf("\n");
  for (const Ratio& ratio : ratios) {
    const auto& fastest = reporter.fastest();
    if (!fastest.contains(ratio.numerator) || !fastest.contains(ratio.denominator)) continue;
    std::printf("%s / %s = %.2f (bound %.2f; fastest repetition of each)\n", ratio.numerator.c_str(),
                ratio.denominator.c_str(), fastest.at(ratio.numerator) / fastest.at(ratio.denominator),
                ratio.bound);
  }
  return 0;
}

}  // namespace shprt::bench
