#include "cli/interrupt.h"

#include <time.h>

#include <atomic>
#include <csignal>
#include <cstdint>

namespace isostack::cli {

namespace {

/// `timeout` and some shells signal both the process and its group: that is one request, not two.
constexpr std::int64_t same_request_ns = 500'000'000;

std::atomic<std::int64_t> first_signal_ns = 0;  // 0: none came
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a signal handler may touch nothing else");

void on_signal(int number) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);  // allowed in signal handlers
  const std::int64_t now_ns = std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
  std::int64_t first = 0;
  if (first_signal_ns.compare_exchange_strong(first, now_ns) || now_ns - first < same_request_ns) return;
  std::signal(number, SIG_DFL);
  std::raise(number);
}

}  // namespace

void watch_for_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool interrupted() { return first_signal_ns != 0; }

}  // namespace isostack::cli
