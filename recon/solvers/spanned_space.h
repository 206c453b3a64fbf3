#pragma once

#include <Eigen/Core>

namespace isostack {

/// Points (n × N) in as few coordinates as they need, at the same distances from each other: axes
/// along which nothing varies are dropped, and points in an oblique plane or on a line are turned into it.
/// A kernel sees distances only, so the weights of the reduced points are those of the original ones.
Eigen::MatrixXd reduced_to_span(const Eigen::MatrixXd& points);

}  // namespace isostack
