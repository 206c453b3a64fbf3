#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "viewers/scene.h"

namespace isostack {

/// The corners of a slice's pixels (not of its pixel centres), world mm: first pixel, along x, opposite, along y.
std::array<Eigen::Vector3d, 4> corners_of(const Slice& slice);

/// Every point that will be drawn, world mm: surface vertices, contour points and slice corners.
/// Throws InputError when there is none, when one is not finite or when a triangle names a missing vertex.
std::vector<Eigen::Vector3d> drawn_points(const Scene& scene);

}  // namespace isostack
