// Ctrl-C. Outside long work it ends the program at once, and what was half written goes with it. In long work
// the first ends it cleanly between two steps, the second at once.
#pragma once

#include <stdexcept>

namespace shprt {

class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

// Takes SIGINT and SIGTERM over for the rest of the program.
void handleInterrupts();

// While one lives, the first signal is only noted; throwIfInterrupted() acts on it.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

void throwIfInterrupted();

}  // namespace shprt
