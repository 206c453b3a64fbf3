#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "recon/geometry/contour.h"
#include "recon/surface/scalar_field.h"

namespace isostack::testing_support {

/// Signed distances (positive inside), mm.
inline double sphere_mm(const Eigen::Vector3d& p, double radius_mm) { return radius_mm - p.norm(); }
inline double torus_mm(const Eigen::Vector3d& p, double ring_mm, double tube_mm) {
  return tube_mm - std::hypot(std::hypot(p.x(), p.y()) - ring_mm, p.z());
}

/// A field with central-difference gradients from a function of one point.
inline ScalarField field_of(std::function<double(const Eigen::Vector3d&)> f) {
  ScalarField field;
  field.values = [f](const Eigen::Matrix3Xd& points) {
    Eigen::VectorXd values(points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) values[i] = f(points.col(i));
    return values;
  };
  field.gradients = [f](const Eigen::Matrix3Xd& points) {
    Eigen::Matrix3Xd gradients(3, points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d step = 1e-5 * Eigen::Vector3d::Unit(axis);
        gradients(axis, i) = (f(points.col(i) + step) - f(points.col(i) - step)) / 2e-5;
      }
    return gradients;
  };
  return field;
}

/// A circle in slice coordinates; `clockwise` makes it a hole.
inline Contour circle(const Eigen::Vector2d& centre_mm, double radius_mm, int points, bool clockwise = false) {
  Contour contour;
  for (int i = 0; i < points; ++i) {
    const double angle = (clockwise ? -1 : 1) * 2 * std::numbers::pi * i / points;
    contour.points_mm.push_back(centre_mm + radius_mm * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  contour.depth = clockwise ? 1 : 0;
  return contour;
}

/// Cuts of a sphere about the world origin by the planes of `pose` shifted along its normal.
inline ContourStack sphere_cuts(double radius_mm, const SlicePose& pose, const std::vector<double>& offsets_mm,
                                int points_per_circle) {
  ContourStack stack{.name = "sphere", .slices = {}};
  for (const double offset_mm : offsets_mm) {
    ContourSlice slice{.name = "z = " + std::to_string(offset_mm), .pose = pose, .contours = {}};
    slice.pose.origin_mm += offset_mm * pose.normal();
    const Eigen::Vector2d centre = slice.pose.world_to_slice(Eigen::Vector3d::Zero());
    const double height = slice.pose.signed_distance_mm(Eigen::Vector3d::Zero());
    if (std::abs(height) < radius_mm)
      slice.contours.push_back(circle(centre, std::sqrt(radius_mm * radius_mm - height * height), points_per_circle));
    stack.slices.push_back(slice);
  }
  return stack;
}

}  // namespace isostack::testing_support
