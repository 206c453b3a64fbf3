#pragma once

#include <Eigen/Core>

namespace isostack {

/// How far the surface at each sample leans over its slice: the cosine between surface normal and plane normal. From
/// gradients at the samples, their places and their planes' unit normals (each 3 × N, mm); the mean over the
/// neighbours' normals within `radius_mm`, weighted by nearness and by how alike they are, so that opposite sides of a
/// thin sheet do not mix (bilateral, as in Tomasi & Manduchi 1998).
///
/// The surface follows the values that its own normals set. Steps of a pixel in contours traced from labels tilt single
/// normals, and without the mean each solve makes such ripples larger.
Eigen::VectorXd smoothed_lean(const Eigen::Matrix3Xd& gradients, const Eigen::Matrix3Xd& points_mm,
                              const Eigen::Matrix3Xd& plane_normals, double radius_mm);

}  // namespace isostack
