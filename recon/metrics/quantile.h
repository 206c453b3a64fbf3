#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace isostack {

/// The value at rank fraction·(count − 1), rounded down. There must be one value at least.
inline double quantile(std::vector<double> values, double fraction) {
  const auto rank = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

inline double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace isostack
