#include "interrupt.h"

#include <csignal>

namespace shprt {
namespace {

// A signal handler can reach nothing but a variable like this one.
volatile std::sig_atomic_t interrupted = 0;

void note(int) {
  interrupted = 1;
}

}  // namespace

InterruptGuard::InterruptGuard() {
  struct sigaction action = {};
  action.sa_handler = note;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, &formerInterrupt_);
  sigaction(SIGTERM, &action, &formerTerminate_);
  // A shell that starts a job in the background has it ignore Ctrl-C; so it stays.
  if (formerInterrupt_.sa_handler == SIG_IGN) sigaction(SIGINT, &formerInterrupt_, nullptr);
}

InterruptGuard::~InterruptGuard() {
  sigaction(SIGINT, &formerInterrupt_, nullptr);
  sigaction(SIGTERM, &formerTerminate_, nullptr);
}

void throwIfInterrupted() {
  if (interrupted) throw Interrupted();
}

}  // namespace shprt
