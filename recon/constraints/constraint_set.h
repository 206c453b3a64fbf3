#pragma once

#include <Eigen/Core>

namespace isostack {

/// What the interpolant has to meet: f(points.col(i)) = values[i], in n dimensions (n × N).
/// f > 0 inside. Smoothing is empty (interpolate) or one ρ ≥ 0 per constraint.
struct ConstraintSet {
  Eigen::MatrixXd points;
  Eigen::VectorXd values;
  Eigen::VectorXd smoothing;
};

}  // namespace isostack
