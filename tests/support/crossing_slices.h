#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack::testing_support {

/// An ellipsoid about the world origin with a bulge, so that no two of its cuts are alike: star-shaped, inside where
/// the result is positive (not a distance).
inline double bulged_ellipsoid(const Eigen::Vector3d& p) {
  const Eigen::Vector3d q = p.cwiseQuotient(Eigen::Vector3d(30, 24, 38));
  const double bulge = 0.25 * std::exp(-(q - Eigen::Vector3d(0.6, 0.4, 0.3)).squaredNorm() / 0.2);
  return 1 + bulge - q.norm();
}

/// A plane through `point_mm` with the given normal; slice (0, 0) is that point.
inline SlicePose plane_through(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& normal, double pixel_mm) {
  SlicePose pose;
  pose.origin_mm = point_mm;
  pose.x_axis = normal.unitOrthogonal();
  pose.y_axis = normal.normalized().cross(pose.x_axis);
  pose.spacing_mm = Eigen::Vector2d::Constant(pixel_mm);
  return pose;
}

/// The cut of a shape f > 0 by a plane whose slice (0, 0) is inside: one ray per point, bisection along it.
template <class Shape>
ContourSlice star_cut(const Shape& shape, const SlicePose& pose, const std::string& name, int points = 240) {
  ContourSlice slice{.name = name, .pose = pose, .contours = {Contour{}}};
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    const Eigen::Vector2d ray(std::cos(angle), std::sin(angle));
    double inside = 0, outside = 200;
    for (int step = 0; step < 50; ++step) {
      const double middle = (inside + outside) / 2;
      (shape(pose.slice_to_world(middle * ray)) > 0 ? inside : outside) = middle;
    }
    slice.contours.front().points_mm.push_back(inside * ray);
  }
  return slice;
}

/// Three orthogonal stacks of four slices each through the bulged ellipsoid.
inline ContourStack orthogonal_slices(double pixel_mm = 0.8) {
  ContourStack stack{.name = "orthogonal", .slices = {}};
  for (int axis = 0; axis < 3; ++axis)
    for (const double place : {-12.0, -4.0, 4.0, 12.0}) {
      const Eigen::Vector3d normal = Eigen::Vector3d::Unit(axis);
      stack.slices.push_back(star_cut(bulged_ellipsoid, plane_through(place * normal, normal, pixel_mm),
                                      std::string(1, "xyz"[axis]) + " " + std::to_string(static_cast<int>(place))));
    }
  return stack;
}

/// Six long-axis planes round the z axis and six short-axis planes across it, as in cardiac imaging.
inline ContourStack cardiac_slices(double pixel_mm = 0.8) {
  ContourStack stack{.name = "cardiac", .slices = {}};
  for (int i = 0; i < 6; ++i) {
    const double angle = std::numbers::pi * i / 6;
    stack.slices.push_back(star_cut(bulged_ellipsoid,
                                    plane_through({0, 0, 0}, {std::cos(angle), std::sin(angle), 0}, pixel_mm),
                                    "long " + std::to_string(i)));
    stack.slices.push_back(star_cut(bulged_ellipsoid,
                                    plane_through({0, 0, 9.0 * i - 22}, Eigen::Vector3d::UnitZ(), pixel_mm),
                                    "short " + std::to_string(i)));
  }
  return stack;
}

}  // namespace isostack::testing_support
