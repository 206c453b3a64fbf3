#include "cli/interrupt.h"

#include <csignal>

namespace isostack::cli {

namespace {

volatile std::sig_atomic_t signal_came = 0;  // the one thing a signal handler may write to

void on_signal(int number) {
  signal_came = 1;
  std::signal(number, SIG_DFL);
}

}  // namespace

void watch_for_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool interrupted() { return signal_came != 0; }

}  // namespace isostack::cli
