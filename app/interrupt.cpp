// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/interrupt.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

namespace limpet::app {
namespace {

volatile std::sig_atomic_t signal_came = 0;

/// Ends standard input, so that nothing waits for it any longer. Only calls that are safe in a signal
/// handler.
void remember(int) {
  signal_came = 1;
  const int error = errno;
  const int nothing = ::open("/dev/null", O_RDONLY);
  if (nothing >= 0) {
    ::dup2(nothing, STDIN_FILENO);
    ::close(nothing);
  }
  errno = error;
}

}  // namespace

void catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = remember;
  // Back to the default after the first. No SA_RESTART: a read that waits for standard input wakes up.
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return signal_came != 0; }

}  // namespace limpet::app
