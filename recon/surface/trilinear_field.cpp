#include "recon/surface/trilinear_field.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace isostack {

namespace {

class Trilinear {
 public:
  explicit Trilinear(std::shared_ptr<const Volume<float>> volume)
      : volume_(std::move(volume)), world_to_index_(volume_->grid.index_to_world.inverse()) {}

  double value(const Eigen::Vector3d& point_mm) const {
    const Eigen::Vector3d index = world_to_index_ * point_mm;
    Eigen::Vector3i low;
    Eigen::Vector3d share;
    for (int axis = 0; axis < 3; ++axis) {
      const int last = volume_->grid.size[axis] - 1;
      const double at = std::clamp(index[axis], 0.0, static_cast<double>(last));
      low[axis] = std::min(static_cast<int>(at), last - 1);
      share[axis] = at - low[axis];
    }
    const auto along_x = [&](int y, int z) {
      const double first = volume_->at(low.x(), low.y() + y, low.z() + z);
      return first + share.x() * (static_cast<double>(volume_->at(low.x() + 1, low.y() + y, low.z() + z)) - first);
    };
    const auto along_y = [&](int z) { return (1 - share.y()) * along_x(0, z) + share.y() * along_x(1, z); };
    return (1 - share.z()) * along_y(0) + share.z() * along_y(1);
  }

  double slope(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& half_step_mm) const {
    return (value(point_mm + half_step_mm) - value(point_mm - half_step_mm)) / (2 * half_step_mm.norm());
  }

  double half_step_mm() const { return volume_->grid.index_to_world.linear().colwise().norm().minCoeff() / 2; }

 private:
  std::shared_ptr<const Volume<float>> volume_;
  Eigen::Affine3d world_to_index_;
};

}  // namespace

ScalarField trilinear_field(std::shared_ptr<const Volume<float>> volume) {
  const Trilinear field(std::move(volume));
  ScalarField result;
  result.values = [field](const Eigen::Matrix3Xd& points) {
    Eigen::VectorXd values(points.cols());
    tbb::parallel_for(Eigen::Index{0}, points.cols(), [&](Eigen::Index i) { values[i] = field.value(points.col(i)); });
    return values;
  };
  result.gradients = [field](const Eigen::Matrix3Xd& points) {
    Eigen::Matrix3Xd gradients(3, points.cols());
    tbb::parallel_for(Eigen::Index{0}, points.cols(), [&](Eigen::Index i) {
      for (int axis = 0; axis < 3; ++axis)
        gradients(axis, i) = field.slope(points.col(i), field.half_step_mm() * Eigen::Vector3d::Unit(axis));
    });
    return gradients;
  };
  return result;
}

}  // namespace isostack
