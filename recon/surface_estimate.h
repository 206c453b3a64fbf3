#pragma once

#include "recon/geometry/contour.h"

namespace isostack {

/// About how large the surface through the contours is, mm², rather too large: of every set of parallel slices the
/// bands between neighbours, slanted as their areas differ, and the two ends; the largest of all sets.
/// Where slices cross, no less than the ellipsoid in the contours' box. At least one slice has a contour.
double estimated_area_mm2(const ContourStack& contours);

}  // namespace isostack
