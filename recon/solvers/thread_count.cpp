#include "recon/solvers/thread_count.h"

#include <oneapi/tbb/info.h>

// OpenBLAS has this entry; another BLAS need not, so it is looked up weakly.
extern "C" __attribute__((weak)) void openblas_set_num_threads(int count);

namespace isostack {

int available_threads() { return tbb::info::default_concurrency(); }

void set_linear_algebra_threads(int count) {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(count);
}

}  // namespace isostack
