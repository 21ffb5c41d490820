#include "shprt/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <memory>
#include <string>

#include "shprt/base/error.h"

namespace shprt {
namespace {

std::unique_ptr<tbb::global_control>& control() {
  static std::unique_ptr<tbb::global_control> instance;
  return instance;
}

}  // namespace

void setThreadCount(int threads) {
  if (threads < 0)
    throw Error("--threads", std::to_string(threads) + " is negative", "give 0 for one per core");
  control().reset();
  if (threads > 0) {
    control() = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                      static_cast<std::size_t>(threads));
  }
}

int threadCount() {
  return static_cast<int>(
      std::min<std::size_t>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism),
                            static_cast<std::size_t>(tbb::info::default_concurrency())));
}

void parallelForBlocks(std::size_t count, std::size_t blockSize,
                       const std::function<void(std::size_t begin, std::size_t end)>& body) {
  if (count == 0) return;
  const std::size_t blocks = (count + blockSize - 1) / blockSize;
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
    const std::size_t begin = block * blockSize;
    body(begin, std::min(begin + blockSize, count));
  });
}

void parallelInvoke(const std::function<void()>& first, const std::function<void()>& second) {
  tbb::parallel_invoke(first, second);
}

}  // namespace shprt
