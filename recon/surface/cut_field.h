#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "recon/surface/scalar_field.h"

namespace isostack {

/// Where a field's surface is cut off, and closed.
struct FieldBounds {
  Eigen::AlignedBox3d box;
  std::vector<Eigen::Hyperplane<double, 3>> half_spaces;  ///< positive within
  /// Gradients asked for this near a bound point away from it, inwards, mm.
  double bound_width_mm = 1e-3;
};

/// min(f, depth within the bounds): its zero set is closed wherever f's leaves the bounds. `was_cut` becomes true once
/// a point is asked for that lies inside f and outside the bounds.
ScalarField cut_to_bounds(const ScalarField& field, const FieldBounds& bounds,
                          const std::shared_ptr<bool>& was_cut = std::make_shared<bool>(false));

}  // namespace isostack
