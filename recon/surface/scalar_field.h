#pragma once

#include <Eigen/Core>
#include <functional>

namespace isostack {

/// A function of space that is positive inside, evaluated in batches. Points are 3 × M, world mm.
struct ScalarField {
  std::function<Eigen::VectorXd(const Eigen::Matrix3Xd&)> values;
  std::function<Eigen::Matrix3Xd(const Eigen::Matrix3Xd&)> gradients;
};

}  // namespace isostack
