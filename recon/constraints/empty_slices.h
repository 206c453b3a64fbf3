#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// A point of a slice in which the organ is absent, and the value f shall have there.
struct OutsidePoint {
  Eigen::Vector3d point_mm;
  double value_mm;
};

/// An empty slice next to one with contours says *outside*. Its points opposite the neighbour's
/// organ get the value −gap/2, so that the surface ends about half way between the two.
/// Only parallel neighbours are considered.
std::vector<OutsidePoint> points_in_empty_slices(const ContourStack& stack);

/// Half the distance from a slice to the nearest parallel one with contours; four pixels if there is none.
double half_gap_to_contours_mm(const ContourStack& stack, const ContourSlice& slice);

}  // namespace isostack
