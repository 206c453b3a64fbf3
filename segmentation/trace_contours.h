#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/slice.h"

namespace isostack {

/// Zero level curves of `phi` (inside where phi >= 0, indexed (row, column)) as closed contours in slice mm,
/// in time proportional to the number of pixels. Marching squares: points lie where the linear interpolation
/// between 4-neighbours is 0; at saddles the sign of the bilinear interpolation's saddle point
/// (asymptotic decider) tells which corners join. The organ lies to the left, depth is the nesting depth.
///
/// Every pixel centre is strictly on its side: crossings keep at least 0.001 pixel from either centre, so
/// points never coincide even where phi is exactly 0. Outside the image is outside the organ: where the organ
/// is cut by the field of view the curve runs half a pixel beyond the border's pixel centres, on the pixels'
/// outer edges (corners of the image are cut diagonally).
/// Infinite values are allowed; the caller excludes NaN (treated as outside).
std::vector<Contour> trace_contours(const Image<float>& phi, const Eigen::Vector2d& spacing_mm);

/// True when the field of view cuts the organ, that is a pixel of the image's border is inside.
bool touches_border(const Image<float>& phi);

/// The same, seen from contours traced by trace_contours; false where the size in pixels is unknown.
bool touches_border(const ContourSlice& slice);

}  // namespace isostack
