#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace isostack {

/// Runs `work(task, result)` for each task in child processes, some at a time, and returns the
/// results of those that returned true; the others are empty. `result` has result_bytes[task]
/// bytes, zero at first. A library that ends its process, writes to the terminal, or runs for more than
/// `cpu_seconds` takes its child with it and loses that task only. `work` runs in a copy of this
/// process that has no other threads: it must not use TBB, and what it changes is lost but for the result.
std::vector<std::vector<char>> run_in_children(const std::vector<std::size_t>& result_bytes,
                                               const std::function<bool(std::size_t task, char* result)>& work,
                                               int cpu_seconds = 60);

}  // namespace isostack
