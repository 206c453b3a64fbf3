#include "recon/surface/cut_field.h"

#include <algorithm>
#include <limits>

namespace isostack {

namespace {

/// Distance to the nearest of the bounds, positive within all of them, and the way in.
struct Depth {
  double mm;
  Eigen::Vector3d inwards;
};

Depth depth_within(const FieldBounds& bounds, const Eigen::Vector3d& p) {
  Depth depth{std::numeric_limits<double>::infinity(), Eigen::Vector3d::Zero()};
  const auto consider = [&](double mm, const Eigen::Vector3d& inwards) {
    if (mm < depth.mm) depth = {mm, inwards};
  };
  for (int axis = 0; axis < 3; ++axis) {
    consider(p[axis] - bounds.box.min()[axis], Eigen::Vector3d::Unit(axis));
    consider(bounds.box.max()[axis] - p[axis], -Eigen::Vector3d::Unit(axis));
  }
  for (const auto& half_space : bounds.half_spaces) consider(half_space.signedDistance(p), half_space.normal());
  return depth;
}

}  // namespace

ScalarField cut_to_bounds(const ScalarField& field, const FieldBounds& bounds, const std::shared_ptr<bool>& was_cut) {
  ScalarField cut;
  cut.values = [field, bounds, was_cut](const Eigen::Matrix3Xd& points) {
    Eigen::VectorXd values = field.values(points);
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const double depth = depth_within(bounds, points.col(i)).mm;
      *was_cut = *was_cut || (depth < 0 && values[i] >= 0);
      values[i] = std::min(values[i], depth);
    }
    return values;
  };
  cut.gradients = [field, bounds](const Eigen::Matrix3Xd& points) {
    Eigen::Matrix3Xd gradients = field.gradients(points);
    for (Eigen::Index i = 0; i < points.cols(); ++i) {  // asked for at vertices: near a bound they lie on it
      const Depth depth = depth_within(bounds, points.col(i));
      if (depth.mm < bounds.bound_width_mm) gradients.col(i) = depth.inwards;
    }
    return gradients;
  };
  return cut;
}

}  // namespace isostack
