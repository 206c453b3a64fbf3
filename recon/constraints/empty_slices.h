#pragma once

#include "recon/geometry/contour.h"

namespace isostack {

/// Half the distance from a slice without the organ to the nearest parallel one with contours, where
/// the surface is expected to end; four pixels if there is none.
double half_gap_to_contours_mm(const ContourStack& stack, const ContourSlice& slice);

}  // namespace isostack
