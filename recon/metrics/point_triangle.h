#pragma once

#include <Eigen/Core>
#include <array>

namespace isostack {

using Triangle = std::array<Eigen::Vector3d, 3>;

/// The point of the (possibly degenerate) triangle nearest to p (Ericson 2005, §5.1.5).
Eigen::Vector3d closest_point_on_triangle(const Triangle& triangle, const Eigen::Vector3d& p);

}  // namespace isostack
