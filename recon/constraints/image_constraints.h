#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/constraints/constraint_set.h"
#include "recon/geometry/slice.h"

namespace isostack {

/// Constraints of Turk & O'Brien 1999, §4.1, in slice pixel coordinates.
struct ImageConstraint {
  Eigen::Vector2d boundary_pixel;  ///< value 0: linear crossing of the level between 4-neighbours
  Eigen::Vector2d normal_pixel;    ///< value 1: one pixel up the gradient from there
};

/// One pair per crossing between a pixel and its east or south neighbour; ≥ level counts as inside.
/// The gradient is taken by central differences of the image (one-sided at its border), interpolated linearly.
std::vector<ImageConstraint> image_constraints(const Image<float>& image, double level);

/// All slices' constraints in world mm, at most `max_constraints` (every k-th pair when there are
/// more): first all boundary points, then their normal points in the same order.
ConstraintSet image_constraint_set(const SliceStack& stack, double level, std::size_t max_constraints);

}  // namespace isostack
