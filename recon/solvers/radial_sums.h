#pragma once

#include <Eigen/Core>

namespace isostack {

/// How many derivatives a sum is asked for, besides its values.
enum class Derivatives { none, first, second };

/// Sums of a radial kernel at M targets, with as many derivatives as were asked for.
struct RadialSums {
  Eigen::VectorXd values;     ///< M
  Eigen::MatrixXd gradients;  ///< n × M, or empty
  Eigen::MatrixXd hessians;   ///< 6 × M: xx, yy, zz, yz, xz, xy (3D throughout); or empty
};

}  // namespace isostack
