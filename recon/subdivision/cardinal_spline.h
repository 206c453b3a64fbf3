#pragma once

#include <Eigen/Core>

namespace isostack {

/// The smooth curve through points, one column each, at ascending parameters: cubic between two points, with the
/// tangent at a point that of the parabola through it and its neighbours (a cardinal spline for any spacing). Beyond
/// the ends it goes on straight.
Eigen::VectorXd cardinal_spline(const Eigen::RowVectorXd& parameters, const Eigen::MatrixXd& points, double at);

}  // namespace isostack
