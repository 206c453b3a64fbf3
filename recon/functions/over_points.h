#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Core>

namespace isostack {

/// value_at(0 … count − 1), in parallel.
template <class ValueAt>
Eigen::ArrayXd over_points(Eigen::Index count, ValueAt value_at) {
  Eigen::ArrayXd values(count);
  tbb::parallel_for(Eigen::Index{0}, count, [&](Eigen::Index i) { values[i] = value_at(i); });
  return values;
}

}  // namespace isostack
