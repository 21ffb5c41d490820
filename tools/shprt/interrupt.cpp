#include "interrupt.h"

#include <unistd.h>

#include <csignal>
#include <string_view>

#include "shprt/base/file.h"

namespace shprt {
namespace {

// A signal handler can reach nothing but variables like these.
volatile std::sig_atomic_t guarded = 0, interrupted = 0;

void endProgram(int signal) {
  removeTemporaryFiles();
  constexpr std::string_view kLine = "\nshprt: interrupted; what was not finished was not written\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kLine.data(), kLine.size());
  ::_exit(128 + signal);
}

void onSignal(int signal) {
  if (!guarded || interrupted) endProgram(signal);
  interrupted = 1;
}

}  // namespace

void handleInterrupts() {
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction former = {}, action = {};
    sigaction(signal, nullptr, &former);
    // A shell that starts a job in the background has it ignore Ctrl-C; so it stays.
    if (former.sa_handler == SIG_IGN) continue;
    action.sa_handler = onSignal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(signal, &action, nullptr);
  }
}

InterruptGuard::InterruptGuard() {
  guarded = 1;
}

InterruptGuard::~InterruptGuard() {
  guarded = 0;
}

void throwIfInterrupted() {
  if (interrupted) throw Interrupted();
}

}  // namespace shprt
