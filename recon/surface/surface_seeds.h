#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "recon/surface/scalar_field.h"

namespace isostack {

/// Points near every part of the field's zero set in the box, for extract_surface where nothing is known of the surface
/// beforehand. The field is looked at on a lattice, and on a lattice four times as fine wherever it has an extremum
/// close to zero, so that bodies and hollows between the nodes are found too. A point is where the straight line
/// between two values of different sign is zero, at most `spacing_mm` apart: within half of that of the surface, much
/// nearer where it is smooth. Where the field has one sign throughout there is none. Throws GeometryError for more than
/// 10⁸ nodes.
std::vector<Eigen::Vector3d> surface_seeds(const ScalarField& field, const Eigen::AlignedBox3d& box, double spacing_mm);

}  // namespace isostack
