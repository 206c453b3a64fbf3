#pragma once

#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/pixel_lattice.h"
#include "recon/geometry/slice.h"

namespace isostack {

/// Signed distance images of parallel slices on one lattice of pixels (Raya & Udupa 1990): what lies between the
/// slices is interpolated from them along the normal, pixel by pixel.
struct SignedDistanceStack {
  PixelLattice lattice;                    ///< of every image; the direction of interpolation is its normal
  std::vector<double> positions_mm;        ///< of the slices along the normal, from the lattice's plane, ascending
  std::vector<Image<float>> distances_mm;  ///< to the slice's contours in its plane, positive inside
};

/// How values go from slice to slice.
enum class AlongNormal {
  linear,  ///< between the two slices next to the position
  cubic    ///< natural cubic spline through all slices
};

/// Exact distance of every pixel centre to the contours' segments, mm, positive inside (even-odd). Throws InputError
/// when there is no contour.
Image<float> signed_distance_image(const std::vector<Contour>& contours, const SlicePose& contours_pose,
                                   const PixelLattice& lattice);

/// A slice without the organ has minus the distance to where the organ is taken to end: half way to the nearest slice
/// with contours, in that slice's shape. Throws GeometryError when slices are not parallel, two lie at one position,
/// there are fewer than two, or none has a contour.
SignedDistanceStack signed_distance_stack(const ContourStack& contours, const PixelLattice& lattice);

/// What each slice's value counts for at a position along the normal; they sum to 1. Beyond the outermost slices the
/// value of the outermost slice holds. Positions ascend.
Eigen::VectorXd weights_along(const std::vector<double>& positions_mm, double at_mm, AlongNormal how);

/// The distances at a position along the normal: the organ is where they are positive.
Image<float> interpolate(const SignedDistanceStack& stack, double at_mm, AlongNormal how);

}  // namespace isostack
