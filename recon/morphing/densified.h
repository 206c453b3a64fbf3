#pragma once

#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// The same curves with points at most a step apart: constraints are points of curves, and a polygon has few.
std::vector<Contour> densified(std::vector<Contour> contours, double step_mm);

}  // namespace isostack
