// Progress on standard error: a bar on a terminal, a line now and then elsewhere.
#pragma once

#include <chrono>
#include <string>

#include "shprt/base/progress.h"

namespace shprt {

class ProgressBar {
 public:
  // quiet shows nothing; the callback then only looks for Ctrl-C.
  ProgressBar(std::string label, bool quiet);
  // Clears the bar.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // For the library to call; the bar must outlive it. Throws Interrupted after Ctrl-C.
  ProgressCallback callback();

 private:
  void show(const ProgressReport& report);

  using Clock = std::chrono::steady_clock;
  std::string label_;
  bool quiet_, terminal_, drawn_ = false;
  Clock::time_point start_, shown_;
};

}  // namespace shprt
