#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/geometry/slice.h"

namespace isostack {

/// Corners of the convex hull, counter-clockwise in (x, y), without points on its edges.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

/// Every part of the region (phi >= 0) becomes its convex hull: signed distance in mm up to a few pixels. Clinical
/// endocardial contours are drawn so, with the papillary muscles counted as blood.
Image<float> hull_of_parts(const Image<float>& phi, const Eigen::Vector2d& spacing_mm);

}  // namespace isostack
