#pragma once

#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// Figures given by their corners, in a field of 96 × 96 pixels of 1 mm, y downwards: the digits 1, 2, 3, 7 and 8
/// ("one", ...), a "pointed" star, a "triangle", a "fan" of which three corners are sharp, and "eight_to_seven": an 8
/// whose holes touch its left edge, where they open on the way to the 7.
std::vector<ContourSlice> outline_figures();

}  // namespace isostack
