#pragma once

#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// What curves that overlap enclose: points within an odd number of them, or within any.
enum class InsideRule { odd, any };

/// Closed curves that enclose the same as the given ones, but neither cross themselves nor one another, nor run along
/// each other: a keyhole becomes an outer curve and a hole; what crosses is cut at the crossings. Curves that have
/// none of this come back as they are (rule `odd`). Places nearer than `tolerance_mm` count as the same, so the others
/// move by no more than about that. Curves of less than a square of that side are left out. Depths and orientations
/// are those of orient_by_nesting. Time grows with the square of the number of points of curves that touch.
std::vector<Contour> simple_loops(const std::vector<Contour>& contours, InsideRule rule = InsideRule::odd,
                                  double tolerance_mm = 0.005);

}  // namespace isostack
