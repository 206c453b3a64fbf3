#include "recon/largest_smoothing.h"

#include <cmath>

namespace isostack {

double largest_smoothing_within(double tolerance_mm, const SmoothingRange& range,
                                const std::function<double(double)>& largest_distance_mm) {
  double within = 0, used_mm = 0, beyond = range.least;
  for (; beyond <= range.most; beyond *= 10) {
    const double distance_mm = largest_distance_mm(beyond);
    if (!(distance_mm <= tolerance_mm)) break;
    within = beyond, used_mm = distance_mm;
  }
  if (within == 0 || beyond > range.most) return within;
  while (beyond / within > range.ratio && used_mm < 0.9 * tolerance_mm) {
    const double middle = std::sqrt(within * beyond);
    const double distance_mm = largest_distance_mm(middle);
    if (distance_mm <= tolerance_mm)
      within = middle, used_mm = distance_mm;
    else
      beyond = middle;
  }
  return within;
}

}  // namespace isostack
