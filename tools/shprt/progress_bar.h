// Progress on standard error: a bar on a terminal, a line now and then elsewhere.
#pragma once

#include <chrono>
#include <string>

#include "interrupt.h"
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

  // What the work has come to, shown at once.
  void setLabel(std::string label);

  // For the library to call; the bar must outlive it. Throws Interrupted after Ctrl-C.
  ProgressCallback callback();

 private:
  void show(const ProgressReport& report);

  using Clock = std::chrono::steady_clock;
  std::string label_;
  bool quiet_, terminal_, drawn_ = false;
  Clock::time_point start_, shown_;
};

// The result of work(callback): long work with a bar, which Ctrl-C ends between two steps.
template <typename Work>
auto withProgress(const char* label, bool quiet, const Work& work) {
  ProgressBar bar(label, quiet);
  const InterruptGuard guard;
  auto result = work(bar.callback());
  throwIfInterrupted();
  return result;
}

}  // namespace shprt
