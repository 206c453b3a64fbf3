#pragma once

namespace isostack {

/// Threads this process may use.
int available_threads();

/// How many threads the BLAS of the dense solver uses (oneTBB's are limited by tbb::global_control).
void set_linear_algebra_threads(int count);

}  // namespace isostack
