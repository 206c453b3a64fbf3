#pragma once

#include <functional>

namespace isostack {

/// Where to look for a smoothing ρ, in the kernel's unit.
struct SmoothingRange {
  double least, most;
  double ratio = 1.3;  ///< settled when the bracket's ends are nearer than this factor
};

/// The largest ρ that keeps largest_distance_mm(ρ) within the tolerance, up to the first ρ that does not: upwards in
/// steps of ten from `least`, then bisection of log ρ, until the bracket is narrow or nine tenths of the tolerance are
/// used. 0 when even `least` is too much. The last ρ asked for need not be the one returned.
double largest_smoothing_within(double tolerance_mm, const SmoothingRange& range,
                                const std::function<double(double)>& largest_distance_mm);

}  // namespace isostack
