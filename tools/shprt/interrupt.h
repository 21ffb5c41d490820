// Ctrl-C in long work: the first ends it cleanly between two steps, the second at once.
#pragma once

#include <csignal>
#include <stdexcept>

namespace shprt {

class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

// While one lives, SIGINT and SIGTERM are only noted; throwIfInterrupted() acts on them.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  struct sigaction formerInterrupt_, formerTerminate_;
};

void throwIfInterrupted();

}  // namespace shprt
