#pragma once

#include <Eigen/Core>
#include <functional>

namespace isostack {

/// A function that defines a solid: f ≥ 0 inside and on the boundary, in mm where it is a distance. Evaluated in
/// batches: points are k × M, mm, one a column. Solids of space-time have time, as mm, for their last coordinate.
using SolidFunction = std::function<Eigen::ArrayXd(const Eigen::MatrixXd& points)>;

}  // namespace isostack
