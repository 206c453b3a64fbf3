#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "recon/geometry/contour.h"
#include "recon/geometry/slice.h"

namespace isostack {

/// The pixel centres of an image: pixel (0, 0) at the pose's origin.
struct PixelLattice {
  SlicePose pose;
  Eigen::Vector2i size_pixels = Eigen::Vector2i::Zero();  ///< columns, rows
};

/// The slice's own pixels. Where its image's size is unknown: pixels of its spacing over all contours of the stack,
/// seen along the slice's normal, and a tenth more on every side.
PixelLattice lattice_of(const ContourSlice& slice, const ContourStack& stack);

/// 1 at the pixel centres within the contours (even-odd), 0 elsewhere; indexed (row, column). The contours are in
/// the frame of `contours_pose`, whose plane must be parallel to the lattice's; they are moved along the normal.
Image<std::uint8_t> pixels_inside(const std::vector<Contour>& contours, const SlicePose& contours_pose,
                                  const PixelLattice& lattice);

/// The contours seen in the frame of another, parallel, pose: moved along the normal.
std::vector<Contour> moved_to(const SlicePose& to, const std::vector<Contour>& contours, const SlicePose& from);

}  // namespace isostack
