#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <cstddef>
#include <string_view>
#include <thread>

#include "recon/geometry/progress.h"

namespace isostack {

/// Runs body(i) for i in 0..count−1 in parallel and reports the share that is done, mapped to [from, to], from the
/// calling thread only. Cancelling ends the loop with Cancelled.
template <class Body>
void for_each_slice(std::size_t count, const Progress& progress, std::string_view stage, double from, double to,
                    Body body) {
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<std::size_t> done = 0;
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    body(i);
    const std::size_t now = ++done;
    if (std::this_thread::get_id() == caller)
      progress.report(stage, from + (to - from) * static_cast<double>(now) / static_cast<double>(count));
  });
  progress.report(stage, to);
}

}  // namespace isostack
