#pragma once

#include <cstddef>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// What a plane figure is, in numbers. Curvature is positive where the figure is convex: 1/r along a disc of radius r,
/// −1/r along a round hole.
struct ContourMeasures {
  double area_mm2 = 0;
  double perimeter_mm = 0;
  std::size_t components = 0;  ///< outer curves
  std::size_t holes = 0;
  double lowest_curvature_per_mm = 0, highest_curvature_per_mm = 0;  ///< 0 when there is no curve
};

/// Curvature is that of the circle through three points of a curve, the outer ones `scale_mm` (> 0) before and behind
/// along it: a corner that turns by the angle α has 2 sin(α/2) / scale. Curves shorter than 4 scales take a quarter of
/// their length. Contours are oriented as usual, the figure to the left.
ContourMeasures measure(const std::vector<Contour>& contours, double scale_mm);

}  // namespace isostack
