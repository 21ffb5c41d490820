// Progress of long work, as a plain callback: the library reports, the caller decides how it looks.
#pragma once

#include <cstdint>
#include <functional>

namespace shprt {

struct ProgressReport {
  std::uint64_t done = 0;   // units of work finished, never decreasing
  std::uint64_t total = 0;  // units in all
  std::uint64_t rays = 0;   // rays traced so far, 0 where the work traces none
};

// Called from one worker thread at a time. An empty function means nobody listens.
using ProgressCallback = std::function<void(const ProgressReport&)>;

}  // namespace shprt
