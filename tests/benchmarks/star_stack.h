// The synthetic contour stack of the benchmarks and of the solvers' tests.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

namespace isostack::benchmarks {

/// Columns come in pairs: a point on a contour (value 0) and its partner 1 mm inside (value 1). World mm.
struct StarStack {
  Eigen::MatrixXd points;  ///< 3 × N
  Eigen::VectorXd values;
};

constexpr double star_slice_gap_mm = 5;

/// The true surface r = 100 + 20 cos(5θ + 0.02 z), z along the stack.
inline Eigen::Vector2d star_point(double angle, double z) {
  return (100 + 20 * std::cos(5 * angle + 0.02 * z)) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

/// Contours of that surface 5 mm apart, points `spacing_mm` apart along them.
inline StarStack star_stack(int slices, double spacing_mm = 1) {
  constexpr int steps = 20'000;
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k < slices; ++k) {
    const double z = star_slice_gap_mm * k;
    double walked = spacing_mm;
    for (int i = 0; i < steps; ++i) {
      const double angle = 2 * std::numbers::pi * i / steps, next = 2 * std::numbers::pi * (i + 1) / steps;
      const Eigen::Vector2d here = star_point(angle, z), along = star_point(next, z) - here;
      if (walked >= spacing_mm) {
        const Eigen::Vector2d inside = here + Eigen::Vector2d(-along.y(), along.x()).normalized();
        points.emplace_back(here.x(), here.y(), z);
        points.emplace_back(inside.x(), inside.y(), z);
        walked -= spacing_mm;
      }
      walked += along.norm();
    }
  }
  StarStack stack;
  stack.points = Eigen::Map<const Eigen::Matrix3Xd>(points.front().data(), 3, static_cast<Eigen::Index>(points.size()));
  stack.values = Eigen::VectorXd::NullaryExpr(stack.points.cols(), [](Eigen::Index i) { return double(i % 2); });
  return stack;
}

/// Its contour points only, and the outward unit normals within the slices' planes, both 3 × N/2.
struct OrientedPoints {
  Eigen::Matrix3Xd points, normals;
};

inline OrientedPoints oriented_points(const StarStack& stack) {
  const Eigen::Index count = stack.points.cols() / 2;
  OrientedPoints oriented{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    oriented.points.col(i) = stack.points.col(2 * i);
    oriented.normals.col(i) = stack.points.col(2 * i) - stack.points.col(2 * i + 1);
  }
  return oriented;
}

}  // namespace isostack::benchmarks
