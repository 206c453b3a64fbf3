#include "recon/constraints/empty_slices.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isostack {

double half_gap_to_contours_mm(const ContourStack& stack, const ContourSlice& slice) {
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (const ContourSlice& other : stack.slices) {
    if (other.contours.empty() || !are_parallel(slice.pose, other.pose)) continue;
    nearest_mm = std::min(nearest_mm, std::abs(slice.pose.signed_distance_mm(other.pose.origin_mm)));
  }
  return std::isfinite(nearest_mm) ? nearest_mm / 2 : 4 * slice.pose.spacing_mm.minCoeff();
}

}  // namespace isostack
