#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "recon/geometry/triangle_mesh.h"
#include "recon/surface/scalar_field.h"

namespace isostack {

/// A point near a surface and the way out of it there (unit).
struct NearSurface {
  Eigen::Vector3d point_mm, outwards;
};

/// The place on the surface for each point, or none where there is no surface nearby that faces the same way.
using Projection = std::function<std::vector<std::optional<Eigen::Vector3d>>(const std::vector<NearSurface>&)>;

/// Onto the nearest triangle within `reach_mm` that faces the same way.
Projection onto_mesh(const TriangleMesh& mesh, double reach_mm);

/// Onto f = 0 by root finding in or against the outward direction, within `reach_mm`, to a ten-thousandth of the
/// distance moved at most. The field is evaluated in batches; it must outlive the projection.
Projection onto_zero_set(const ScalarField& field, double reach_mm);

}  // namespace isostack
