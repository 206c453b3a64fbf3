#pragma once

namespace isostack {

/// Threads this process may use.
int available_threads();

/// As long as one lives, BLAS works in the thread that calls it. Sums by BLAS's own threads round differently with
/// their number; work that is cut into the same parts for oneTBB whatever their number does not.
class OneBlasThread {
 public:
  OneBlasThread();
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;
};

}  // namespace isostack
