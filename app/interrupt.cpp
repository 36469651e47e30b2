// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/interrupt.hpp>

#include <csignal>

namespace limpet::app {
namespace {

volatile std::sig_atomic_t signal_came = 0;

void remember(int signal) {
  if (signal_came != 0) {  // the second one: blocked until here is left, and then taken as usual
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  signal_came = 1;
}

void take(int signal) {
  struct sigaction action = {};
  action.sa_handler = remember;
  // No SA_RESTART: what waits for input wakes up.
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_interrupts() {
  take(SIGINT);
  take(SIGTERM);
  struct sigaction before = {};  // a run under nohup goes on when the terminal goes
  if (sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) take(SIGHUP);
}

bool interrupted() { return signal_came != 0; }

}  // namespace limpet::app
