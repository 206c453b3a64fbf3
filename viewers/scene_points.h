#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "viewers/grey_window.h"
#include "viewers/scene.h"

namespace isostack {

/// The corners of a slice's pixels (not of its pixel centres), world mm: first pixel, along x, opposite, along y.
std::array<Eigen::Vector3d, 4> corners_of(const Slice& slice);

/// Every point that is visible, world mm: surface vertices, contour points, slice corners and ends of marks.
std::vector<Eigen::Vector3d> visible_points(const Scene& scene);

/// Of all slices of the scene, hidden ones too.
GreyWindow automatic_grey_window(const Scene& scene);

/// Throws InputError when the scene has nothing to draw, a coordinate is not a finite number, a triangle names a
/// missing vertex, or there is not one value per vertex.
void require_drawable(const Scene& scene);

}  // namespace isostack
