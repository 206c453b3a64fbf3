// The constraints of a 4D morph: two star-like spheres, at t = 0 and at t = 100.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace isostack::benchmarks {

/// A point on one of the key shapes, in the direction of a unit vector.
inline Eigen::Vector3d key_shape_point(int shape, const Eigen::Vector3d& direction, double radius) {
  const double angle = std::atan2(direction.y(), direction.x());
  const double z2 = direction.z() * direction.z(), belt = (1 - z2) * (1 - z2);
  if (shape == 0) return radius * (1 + 0.25 * std::cos(4 * angle) * belt) * direction;  // four lobes
  const double stretch = 1 + 0.3 * z2 - 0.2 * std::cos(3 * angle) * belt;               // three, flattened
  return radius * stretch * direction.cwiseProduct(Eigen::Vector3d(1, 1, 0.7));
}

/// Its outward normal there, by finite differences along two tangents of the sphere.
inline Eigen::Vector3d key_shape_normal(int shape, const Eigen::Vector3d& direction, double radius) {
  constexpr double step = 1e-4;
  const Eigen::Vector3d u = direction.unitOrthogonal(), v = direction.cross(u);
  const Eigen::Vector3d here = key_shape_point(shape, direction, radius);
  const Eigen::Vector3d along_u = key_shape_point(shape, (direction + step * u).normalized(), radius) - here;
  const Eigen::Vector3d along_v = key_shape_point(shape, (direction + step * v).normalized(), radius) - here;
  return along_u.cross(along_v).normalized();
}

struct MorphConstraints {
  Eigen::MatrixXd points;  ///< 4 × N: x, y, z, t
  Eigen::VectorXd values;  ///< pairs: 0 on the surface, 1 at its partner one unit inside
};

/// `per_surface` points of a Fibonacci lattice on each of the two shapes, about one unit apart.
inline MorphConstraints morph_constraints(int per_surface) {
  const double radius = std::sqrt(per_surface / (4 * std::numbers::pi));
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  MorphConstraints result{Eigen::MatrixXd(4, 4 * per_surface), Eigen::VectorXd(4 * per_surface)};
  Eigen::Index column = 0;
  for (int shape = 0; shape < 2; ++shape) {
    const double t = 100.0 * shape;
    for (int i = 0; i < per_surface; ++i) {
      const double z = 1 - 2 * (i + 0.5) / per_surface, ring = std::sqrt(1 - z * z), angle = i * golden_angle;
      const Eigen::Vector3d direction(ring * std::cos(angle), ring * std::sin(angle), z);
      const Eigen::Vector3d on = key_shape_point(shape, direction, radius);
      const Eigen::Vector3d inside = on - key_shape_normal(shape, direction, radius);
      result.points.col(column) << on, t;
      result.values[column++] = 0;
      result.points.col(column) << inside, t;
      result.values[column++] = 1;
    }
  }
  return result;
}

}  // namespace isostack::benchmarks
