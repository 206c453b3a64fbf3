#pragma once

#include <Eigen/Core>

namespace isostack {

/// Sum of weighted squared distances to planes and points, as xᵀAx − 2bᵀx + c (Garland & Heckbert 1997).
struct Quadric {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double c = 0;

  void add_plane(const Eigen::Vector3d& unit_normal, const Eigen::Vector3d& through, double weight) {
    const double offset = unit_normal.dot(through);
    a += weight * unit_normal * unit_normal.transpose();
    b += weight * offset * unit_normal;
    c += weight * offset * offset;
  }
  void add_point(const Eigen::Vector3d& point, double weight) {
    a.diagonal().array() += weight;
    b += weight * point;
    c += weight * point.squaredNorm();
  }
  Quadric operator+(const Quadric& other) const { return {a + other.a, b + other.b, c + other.c}; }
  double at(const Eigen::Vector3d& x) const { return x.dot(a * x) - 2 * b.dot(x) + c; }
};

}  // namespace isostack
